#include "shade/lit_ground.h"

#include <gtest/gtest.h>

#include <random>

#include "terrain/grids.h"

namespace overfly {
namespace {

// Light that tells each vertex from all others.
GroundLight light_of(const TerrainMesh& mesh) {
    GroundLight light;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> share(0.0F, 1.0F);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        light.radiance.push_back({share(random), share(random), share(random)});
        light.without_sun.push_back({share(random), share(random), share(random)});
    }
    return light;
}

TerrainMesh mesh_of(const ElevationModel& model) {
    const Grid grid;
    return triangulate(model, frame_at(grid), locate_in(grid, model));
}

// Everywhere on every triangle of the full mesh, also beside voids.
TEST(LitGround, IsLinearOverTheTrianglesOfTheFullMesh) {
    const TerrainMesh mesh = mesh_of(rough(23, 17, 0.1, 5));
    const GroundLight light = light_of(mesh);
    const LitGround ground(mesh, light);
    std::mt19937 random(4);
    std::uniform_real_distribution<float> share(0.0F, 1.0F);
    for (const auto& t : mesh.triangles) {
        for (int i = 0; i < 8; ++i) {
            float b1 = share(random), b2 = share(random);
            if (b1 + b2 > 1.0F) b1 = 1.0F - b1, b2 = 1.0F - b2;
            const float b0 = 1.0F - b1 - b2;
            const auto place = [&](auto GridPlace::*of) {
                return static_cast<double>(b0) * (mesh.samples[t[0]].*of) +
                       static_cast<double>(b1) * (mesh.samples[t[1]].*of) +
                       static_cast<double>(b2) * (mesh.samples[t[2]].*of);
            };
            for (const bool in_shadow : {false, true}) {
                const auto& of = in_shadow ? light.without_sun : light.radiance;
                const Rgb expected = b0 * of[t[0]] + b1 * of[t[1]] + b2 * of[t[2]];
                const Rgb found = ground.at({place(&GridPlace::column), place(&GridPlace::row)}, in_shadow).radiance;
                EXPECT_NEAR(found.r, expected.r, 1e-5F);
                EXPECT_NEAR(found.g, expected.g, 1e-5F);
                EXPECT_NEAR(found.b, expected.b, 1e-5F);
            }
        }
    }
}

TEST(LitGround, HasTheLightNextToPlacesBesideIt) {
    ElevationModel model = flat(6, 5);
    for (int row = 0; row < 5; ++row) model.is_valid[model.index(4, row)] = model.is_valid[model.index(5, row)] = 0;
    const TerrainMesh mesh = mesh_of(model);
    GroundLight light;
    light.radiance.assign(mesh.positions.size(), {0.25F, 0.5F, 0.75F});
    light.without_sun = light.radiance;
    const LitGround ground(mesh, light);
    for (const auto& [column, row] : {std::pair(3.0001, 2.5), {-0.001, 1.0}, {1.0, 4.0001}, {3.0001, 4.0001}}) {
        const Rgb found = ground.at({column, row}, false).radiance;
        EXPECT_NEAR(found.r, 0.25F, 1e-6F) << column << " " << row;
        EXPECT_NEAR(found.b, 0.75F, 1e-6F) << column << " " << row;
    }
}

TEST(LitGround, CountsHeightsFromTheLowestGround) {
    ElevationModel model = flat(3, 3);
    model.height_m[model.index(1, 1)] = 50.0F;
    const TerrainMesh mesh = mesh_of(model);
    const LitGround ground(mesh, light_of(mesh));
    EXPECT_NEAR(ground.at({1.0, 1.0}, false).height_m, 0.0, 1e-3);
    EXPECT_NEAR(ground.at({0.0, 0.0}, false).height_m, 50.0, 0.1);
}

}  // namespace
}  // namespace overfly
