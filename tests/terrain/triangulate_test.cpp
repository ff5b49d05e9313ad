#include "terrain/triangulate.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "terrain/grids.h"
#include "terrain/mesh_laws.h"

namespace overfly {
namespace {

TerrainMesh mesh_of(const ElevationModel& model, const Grid& grid = {}) {
    return triangulate(model, frame_at(grid), locate_in(grid, model));
}

bool has_side(const TerrainMesh& mesh, VertexId a, VertexId b) {
    for (const auto& v : mesh.triangles)
        for (unsigned k = 0; k < 3; ++k)
            if ((v[k] == a && v[(k + 1) % 3] == b) || (v[k] == b && v[(k + 1) % 3] == a)) return true;
    return false;
}

TEST(Triangulate, MakesTwoTrianglesOfACell) {
    const TerrainMesh mesh = mesh_of(flat(2, 2));
    EXPECT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(broken_mesh_law(mesh, frame_at({})), "");
}

TEST(Triangulate, RefusesLessThanACell) { EXPECT_THROW((void)mesh_of(flat(2, 1)), InternalError); }

// A plane with one corner lifted bends least along the diagonal between the lifted corner's neighbours.
TEST(Triangulate, SplitsACellWhereItBendsLess) {
    for (const std::size_t lifted : {0U, 1U, 2U, 3U}) {
        ElevationModel model = flat(2, 2);
        model.height_m[lifted] += 60.0F;
        const TerrainMesh mesh = mesh_of(model);
        const bool is_on_first_diagonal = lifted == 0 || lifted == 3;
        EXPECT_EQ(has_side(mesh, 1, 2), is_on_first_diagonal) << "corner " << lifted;
        EXPECT_EQ(has_side(mesh, 0, 3), !is_on_first_diagonal) << "corner " << lifted;
    }
}

TEST(Triangulate, KeepsTheTriangleOppositeAMaskedCorner) {
    for (const std::size_t masked : {0U, 1U, 2U, 3U}) {
        ElevationModel model = flat(2, 2);
        model.is_valid[masked] = 0;
        const TerrainMesh mesh = mesh_of(model);
        EXPECT_EQ(mesh.triangles.size(), 1U) << "corner " << masked;
        EXPECT_EQ(mesh.positions.size(), 3U) << "corner " << masked;
        EXPECT_EQ(broken_mesh_law(mesh, frame_at({})), "") << "corner " << masked;
    }
}

TEST(Triangulate, LeavesAHoleWhereTwoCornersAreMasked) {
    ElevationModel model = flat(3, 3);
    model.is_valid[model.index(1, 1)] = 0;
    EXPECT_EQ(mesh_of(model).triangles.size(), 4U);
    EXPECT_EQ(mesh_of(model).positions.size(), 8U);
    model.is_valid[model.index(0, 1)] = 0;  // now the first corner is in one cell, and that has two corners masked
    const TerrainMesh mesh = mesh_of(model);
    EXPECT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.positions.size(), 5U) << "samples without a triangle are no vertices";
    EXPECT_EQ(broken_mesh_law(mesh, frame_at({})), "");
}

TEST(Triangulate, MakesNothingOfNothing) {
    ElevationModel model = flat(4, 3);
    model.is_valid.assign(model.size(), 0);
    const TerrainMesh mesh = mesh_of(model);
    EXPECT_TRUE(mesh.triangles.empty());
    EXPECT_TRUE(mesh.positions.empty());
}

TEST(Triangulate, NumbersVerticesAndTrianglesByRows) {
    const TerrainMesh mesh = mesh_of(flat(3, 2));
    for (VertexId v = 0; v + 1 < mesh.positions.size(); ++v) {
        if (v == 2) continue;
        EXPECT_GT(mesh.positions[v + 1].x, mesh.positions[v].x);
    }
    for (std::size_t t = 0; t < 2; ++t)
        for (const VertexId v : mesh.triangles[t]) EXPECT_NE(v % 3, 2U) << "the first cell's triangles come first";
}

// The laws hold on rough ground with holes, for any handedness of the raster and anywhere on the Earth.
TEST(Triangulate, KeepsTheLawsOfTerrainMesh) {
    const Grid grids[] = {{10, 45, 0.001, -0.001},     {10, 45, 0.001, 0.001},     {10, 45, -0.001, -0.001},
                          {10, 45, -0.001, 0.001},     {179.99, 1, 0.001, -0.001}, {-60, -89.5, 0.2, -0.001},
                          {359.995, 88.9, 0.05, 0.001}};
    unsigned seed = 0;
    for (const Grid& grid : grids)
        for (const double masked_share : {0.0, 0.05, 0.3, 0.7}) {
            const ElevationModel model = rough(31, 23, masked_share, ++seed);
            const TerrainMesh mesh = mesh_of(model, grid);
            EXPECT_EQ(broken_mesh_law(mesh, frame_at(grid)), "") << "seed " << seed;
            std::size_t expected = 0;
            for (int row = 0; row + 1 < model.rows; ++row)
                for (int column = 0; column + 1 < model.columns; ++column) {
                    const int measured =
                        model.is_valid[model.index(column, row)] + model.is_valid[model.index(column + 1, row)] +
                        model.is_valid[model.index(column, row + 1)] + model.is_valid[model.index(column + 1, row + 1)];
                    expected += measured == 4 ? 2U : measured == 3 ? 1U : 0U;
                }
            EXPECT_EQ(mesh.triangles.size(), expected) << "seed " << seed;
        }
}

// A row of samples at the pole itself is one place many times: triangles without area, but joined as everywhere.
TEST(Triangulate, TakesARowAtThePole) {
    const Grid grid{0, 90, 5, -0.01};
    for (const double row_step_deg : {-0.01, 0.01}) {
        Grid g = grid;
        g.row_step_deg = row_step_deg;
        g.lat_deg = row_step_deg < 0 ? 90 : -90;
        const TerrainMesh mesh = mesh_of(flat(72, 4), g);
        EXPECT_EQ(broken_mesh_law(mesh, frame_at(g), true), "");
    }
}

TEST(Triangulate, ElevationIsTheHeightAboveTheEllipsoid) {
    const ElevationModel model = rough(5, 4, 0.0, 7);
    const TerrainMesh mesh = mesh_of(model);
    ASSERT_EQ(mesh.elevation_m.size(), model.size());
    for (std::size_t i = 0; i < model.size(); ++i) {
        EXPECT_FLOAT_EQ(mesh.elevation_m[i], model.height_m[i]);
        EXPECT_NEAR(frame_at({}).geodetic(mesh.positions[i]).height_m, static_cast<double>(model.height_m[i]), 1e-5);
    }
}

TEST(Triangulate, IsTheSameForAnyNumberOfThreads) {
    const ElevationModel model = rough(211, 173, 0.1, 3);
    const int before = thread_limit();
    limit_threads(1);
    const TerrainMesh one = mesh_of(model);
    limit_threads(2);
    const TerrainMesh two = mesh_of(model);
    limit_threads(before);
    EXPECT_TRUE(one == two);
}

}  // namespace
}  // namespace overfly
