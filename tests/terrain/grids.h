#pragma once

#include <random>

#include "geo/scene_frame.h"
#include "terrain/elevation_model.h"
#include "terrain/triangulate.h"

namespace overfly {

// Where a grid's first sample is, and how far it is to the next: negative steps make rows that run south, or columns
// that run west.
struct Grid {
    double lon_deg = 10.0, lat_deg = 45.0;
    double column_step_deg = 0.001, row_step_deg = -0.001;
};

inline LocateRow locate_in(const Grid& grid, const ElevationModel& model) {
    return [grid, &model](int row, std::span<Geodetic> places) {
        for (int column = 0; column < model.columns; ++column)
            places[static_cast<std::size_t>(column)] = {Angle::degrees(grid.lon_deg + column * grid.column_step_deg),
                                                        Angle::degrees(grid.lat_deg + row * grid.row_step_deg),
                                                        static_cast<double>(model.height_m[model.index(column, row)])};
    };
}

inline ElevationModel flat(int columns, int rows) {
    const std::size_t count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    return {columns, rows, std::vector<float>(count, 100.0F), std::vector<std::uint8_t>(count, 1)};
}

inline ElevationModel rough(int columns, int rows, double masked_share, unsigned seed) {
    ElevationModel model = flat(columns, rows);
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> height_m(0.0F, 80.0F);
    std::bernoulli_distribution is_masked(masked_share);
    for (std::size_t i = 0; i < model.size(); ++i) {
        model.height_m[i] = height_m(random);
        model.is_valid[i] = is_masked(random) ? 0 : 1;
    }
    return model;
}

inline SceneFrame frame_at(const Grid& grid) {
    return SceneFrame({Angle::degrees(grid.lon_deg), Angle::degrees(grid.lat_deg), 0});
}

}  // namespace overfly
