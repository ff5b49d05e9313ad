#include "shade/far_ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shade/daylight.h"
#include "support/terrains.h"

namespace overfly {
namespace {

TEST(FarGround, HasTheHeightAndLightOfTheLowerBorder) {
    // A border half in the plain at 0 m, half on a plateau at 800 m, and a peak inside.
    const auto ground_m = [](double x, double y) {
        return x > 10.0 ? 800.0 : std::abs(x) + std::abs(y) < 10.0 ? 3000.0 : 0.0;
    };
    const TerrainMesh mesh = testing::heightfield(21, 21, 50.0, ground_m);
    GroundLight light;
    for (const Point<Scene>& p : mesh.positions) {
        light.radiance.push_back(p.z > 400.0 ? Rgb{9.0F, 9.0F, 9.0F} : Rgb{0.1F, 0.2F, 0.3F});
    }
    const FarGround far(mesh, light);
    EXPECT_NEAR(far.height_m, 0.0, 0.1);
    EXPECT_NEAR(far.radiance.r, 0.1F, 1e-4F);
    EXPECT_NEAR(far.radiance.g, 0.2F, 1e-4F);
    EXPECT_NEAR(far.radiance.b, 0.3F, 1e-4F);
}

TEST(FarGround, IsSeenFromAboveAlone) {
    const TerrainMesh mesh = testing::heightfield(3, 3, 50.0, [](double, double) { return 500.0; });
    GroundLight light;
    light.radiance.assign(mesh.positions.size(), Rgb{});
    const FarGround far(mesh, light);
    const auto below_the_camera_m = far.distance_m({0.0, 0.0, 2500.0}, {0.0, 0.0, -1.0});
    ASSERT_TRUE(below_the_camera_m.has_value());
    EXPECT_NEAR(*below_the_camera_m, 2000.0, 0.1);
    EXPECT_FALSE(far.distance_m({0.0, 0.0, 2500.0}, {0.6, 0.0, 0.8}).has_value());
    EXPECT_FALSE(far.distance_m({0.0, 0.0, 100.0}, {0.0, 0.0, -1.0}).has_value());
}

}  // namespace
}  // namespace overfly
