#include "terrain/flight_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/parallel.h"
#include "terrain/grids.h"
#include "terrain/mesh_laws.h"
#include "terrain/sample_lattice.h"

namespace overfly {
namespace {

// Hills with wrinkles.
ElevationModel hilly(int columns, int rows) {
    ElevationModel model = flat(columns, rows);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double z =
                300.0 * std::sin(0.03 * column) * std::cos(0.021 * row) + 20.0 * std::sin(0.3 * column + 0.2 * row);
            model.height_m[model.index(column, row)] = static_cast<float>(z);
        }
    }
    return model;
}

TerrainMesh within(const ElevationModel& model, const AllowedError& allowed_m, const Grid& grid = {}) {
    return triangulate_within(triangulate(model, frame_at(grid), locate_in(grid, model)), frame_at(grid), allowed_m);
}

AllowedError everywhere(double error_m) {
    return [error_m](Point<Scene>, double) { return error_m; };
}

// The farthest that any measured sample is from the mesh above or below it, by the triangles' shadows in the plane of
// the scene, and how many samples lie under no triangle.
struct Rescan {
    double farthest_m = 0.0;
    int uncovered = 0;
};

Rescan rescan(const ElevationModel& model, const TerrainMesh& mesh, const Grid& grid = {}) {
    const SceneFrame frame = frame_at(grid);
    const LocateRow locate = locate_in(grid, model);
    Rescan result;
    for (int row = 0; row < model.rows; ++row) {
        std::vector<Geodetic> places(static_cast<std::size_t>(model.columns));
        locate(row, places);
        for (int column = 0; column < model.columns; ++column) {
            if (model.is_valid[model.index(column, row)] == 0) continue;
            const Point<Scene> p = frame.scene(places[static_cast<std::size_t>(column)]);
            double nearest_m = std::numeric_limits<double>::infinity();
            for (const auto& t : mesh.triangles) {
                const Point<Scene> a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
                const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
                const double in_b = ((p.x - a.x) * (c.y - a.y) - (c.x - a.x) * (p.y - a.y)) / area;
                const double in_c = ((b.x - a.x) * (p.y - a.y) - (p.x - a.x) * (b.y - a.y)) / area;
                // Seen in the grid samples of a triangle's side lie on it; in the scene the sides bend a little.
                if (in_b < -1e-3 || in_c < -1e-3 || in_b + in_c > 1.001) continue;
                const double z = a.z + in_b * (b.z - a.z) + in_c * (c.z - a.z);
                nearest_m = std::min(nearest_m, std::abs(p.z - z));
            }
            if (std::isinf(nearest_m)) {
                ++result.uncovered;
            } else {
                result.farthest_m = std::max(result.farthest_m, nearest_m);
            }
        }
    }
    return result;
}

TEST(FlightMesh, KeepsTheBound) {
    const ElevationModel model = hilly(150, 97);
    std::size_t last = 2 * 149 * 96 + 1;
    for (const double error_m : {0.0, 1.0, 5.0, 30.0, 1000.0}) {
        const TerrainMesh mesh = within(model, everywhere(error_m));
        EXPECT_EQ(broken_mesh_law(mesh, frame_at({})), "") << error_m;
        const Rescan found = rescan(model, mesh);
        // A little more than nothing: along the vertical of the scene, not of the place.
        EXPECT_LE(found.farthest_m, error_m * 1.05 + 1e-6) << error_m;
        EXPECT_EQ(found.uncovered, 0) << error_m;
        EXPECT_LT(mesh.triangles.size(), last) << error_m;
        last = mesh.triangles.size();
    }
}

TEST(FlightMesh, WithoutAllowanceHasEverySample) {
    const ElevationModel model = hilly(70, 41);
    const TerrainMesh mesh = within(model, everywhere(0.0));
    EXPECT_EQ(mesh.positions.size(), model.size());
    EXPECT_EQ(mesh.triangles.size(), 2U * 69U * 40U);
}

// Ground like an egg box: samples of all kinds fit a coarse triangle, the middles of the cells between them don't.
TEST(FlightMesh, SplitsCellsAsTheFullMeshDoes) {
    ElevationModel model = flat(33, 33);
    for (int row = 0; row < 33; ++row) {
        for (int column = 0; column < 33; ++column) {
            model.height_m[model.index(column, row)] = (column + row) % 2 == 0 ? 100.0F : 130.0F;
        }
    }
    const auto sides = [](const TerrainMesh& mesh) {
        std::vector<std::array<int, 4>> all;
        for (const auto& t : mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const GridPlace a = mesh.samples[t[k]], b = mesh.samples[t[(k + 1) % 3]];
                if (a.column < b.column) all.push_back({a.column, a.row, b.column, b.row});
            }
        }
        std::ranges::sort(all);
        return all;
    };
    const TerrainMesh full = triangulate(model, frame_at({}), locate_in({}, model));
    EXPECT_EQ(sides(within(model, everywhere(5.0))), sides(full));
    // Cells between heights of 100, 130, 100 and 130 m: by 15 m either way they are the same.
    EXPECT_LT(within(model, everywhere(31.0)).triangles.size(), full.triangles.size() / 4);
}

TEST(FlightMesh, HasNoCracks) {
    const ElevationModel model = hilly(300, 290);
    const TerrainMesh mesh = within(model, everywhere(4.0));
    // Sides without a twin form the rectangle of the raster, each of its border lines once.
    double length_deg = 0.0;
    const SceneFrame frame = frame_at({});
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (unsigned k = 0; k < 3; ++k) {
            if (mesh.twins[t][k] != kNone) continue;
            const Geodetic a = frame.geodetic(mesh.positions[mesh.triangles[t][k]]);
            const Geodetic b = frame.geodetic(mesh.positions[mesh.triangles[t][(k + 1) % 3]]);
            const double east_deg = std::abs(a.lon.degrees() - b.lon.degrees());
            const double north_deg = std::abs(a.lat.degrees() - b.lat.degrees());
            EXPECT_LT(std::min(east_deg, north_deg), 1e-9);
            length_deg += std::max(east_deg, north_deg);
        }
    }
    EXPECT_NEAR(length_deg, 2 * (299 + 289) * 0.001, 1e-6);
}

TEST(FlightMesh, KeepsVoidsToTheSample) {
    ElevationModel model = hilly(120, 110);
    for (int row = 30; row < 70; ++row) {
        for (int column = 20; column < 90; ++column) {
            if (std::hypot(column - 50.0, row - 50.0) < 18.0) model.is_valid[model.index(column, row)] = 0;
        }
    }
    model.is_valid[model.index(100, 5)] = 0;
    const TerrainMesh mesh = within(model, everywhere(3.0));
    EXPECT_EQ(broken_mesh_law(mesh, frame_at({})), "");
    const Rescan found = rescan(model, mesh);
    EXPECT_EQ(found.uncovered, 0);
    EXPECT_LE(found.farthest_m, 3.2);
    // As much ground as the full mesh has, seen from above: no void is bridged and none has grown.
    const auto area = [](const TerrainMesh& m) {
        double sum = 0.0;
        for (const auto& t : m.triangles) {
            const Vector<Scene> b = m.positions[t[1]] - m.positions[t[0]], c = m.positions[t[2]] - m.positions[t[0]];
            sum += 0.5 * (b.x * c.y - c.x * b.y);
        }
        return sum;
    };
    const TerrainMesh full = triangulate(model, frame_at({}), locate_in({}, model));
    EXPECT_NEAR(area(mesh) / area(full), 1.0, 1e-5);
}

TEST(FlightMesh, HoldsRoughVoids) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const ElevationModel model = rough(60, 47, 0.15, seed);
        const TerrainMesh mesh = within(model, everywhere(25.0));
        EXPECT_EQ(broken_mesh_law(mesh, frame_at({})), "") << "seed " << seed;
        EXPECT_EQ(rescan(model, mesh).uncovered,
                  rescan(model, triangulate(model, frame_at({}), locate_in({}, model))).uncovered);
    }
}

TEST(FlightMesh, IsFinerWhereLessIsAllowed) {
    const ElevationModel model = hilly(257, 129);
    const AllowedError by_place = [](Point<Scene> middle, double) { return middle.x < 10'000.0 ? 1.0 : 50.0; };
    const TerrainMesh mesh = within(model, by_place);
    const auto west = std::ranges::count_if(mesh.positions, [](Point<Scene> p) { return p.x < 10'000.0; });
    EXPECT_GT(west, static_cast<long>(mesh.positions.size()) * 3 / 4);
}

TEST(FlightMesh, IsTheSameForAnyNumberOfThreads) {
    const ElevationModel model = hilly(280, 270);
    const int before = thread_limit();
    limit_threads(1);
    const TerrainMesh one = within(model, everywhere(4.0));
    limit_threads(std::max(before, 3));
    const TerrainMesh many = within(model, everywhere(4.0));
    limit_threads(before);
    EXPECT_EQ(one, many);
}

TEST(FlightMesh, RunsAnticlockwiseInRastersOfEitherHandedness) {
    const ElevationModel model = hilly(50, 60);
    const Grid northward = {10.0, 45.0, 0.001, 0.001};
    const TerrainMesh mesh = within(model, everywhere(2.0), northward);
    EXPECT_EQ(broken_mesh_law(mesh, frame_at(northward)), "");
}

}  // namespace
}  // namespace overfly
