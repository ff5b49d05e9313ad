#include "shade/lit_ground.h"

#include <algorithm>
#include <cmath>

#include "shade/daylight.h"
#include "terrain/sample_grid.h"

namespace overfly {

LitGround::LitGround(const TerrainMesh& full, const GroundLight& light) : far_(full, light) {
    const SampleGrid grid(full);
    columns_ = grid.columns;
    rows_ = grid.rows;
    if (full.positions.empty()) return;
    lowest_m_ = height_over_ball_m(full.positions.front());
    for (const Point<Scene>& p : full.positions) lowest_m_ = std::min(lowest_m_, height_over_ball_m(p));
    in_sun_.resize(grid.vertex.size());
    without_sun_.resize(in_sun_.size());
    std::vector<std::uint8_t> is_known(in_sun_.size(), 0);
    for (std::size_t i = 0; i < in_sun_.size(); ++i) {
        const VertexId v = grid.vertex[i];
        if (v == kNone) continue;
        is_known[i] = 1;
        const auto height_m = static_cast<float>(height_over_ball_m(full.positions[v]) - lowest_m_);
        const Rgb sun = light.radiance[v], shade = light.without_sun[v];
        in_sun_[i] = Sample{sun.r, sun.g, sun.b, height_m};
        without_sun_[i] = Sample{shade.r, shade.g, shade.b, height_m};
    }
    fill_beside(is_known);
    for (std::size_t i = 0; i < in_sun_.size(); ++i) {
        if (grid.diagonal[i] == 0) continue;
        for (auto* samples : {&in_sun_, &without_sun_}) (*samples)[i][3] = -(*samples)[i][3];
    }
}

// Samples without ground that are beside one with ground take its light: rounding may look a little past an edge.
void LitGround::fill_beside(const std::vector<std::uint8_t>& is_known) {
    const auto columns = static_cast<std::size_t>(columns_);
    const std::size_t rows = in_sun_.size() / columns;
    for (std::size_t i = 0; i < in_sun_.size(); ++i) {
        if (is_known[i] != 0) continue;
        const std::size_t row = i / columns, column = i % columns;
        for (std::size_t r = row > 0 ? row - 1 : 0; r < std::min(row + 2, rows); ++r) {
            for (std::size_t c = column > 0 ? column - 1 : 0; c < std::min(column + 2, columns); ++c) {
                if (is_known[r * columns + c] == 0) continue;
                in_sun_[i] = in_sun_[r * columns + c];
                without_sun_[i] = without_sun_[r * columns + c];
            }
        }
    }
}

LitGround::Way LitGround::way(RasterPlace from, RasterPlace to) {
    const double columns = to.column - from.column;
    const double rows = to.row - from.row;
    const double cells = std::max(std::abs(columns), std::abs(rows));
    const double looks = std::clamp(std::ceil(cells + kLooksMore), 1.0, kMostLooks);
    const double step = 1.0 / looks;
    const double step_columns = step * columns, step_rows = step * rows;
    return {from.column + 0.5 * step_columns, from.row + 0.5 * step_rows, step_columns, step_rows,
            static_cast<int>(looks)};
}

}  // namespace overfly
