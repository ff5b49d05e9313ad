#include "shade/sky_nodes.h"

#include <gtest/gtest.h>

#include <cstdint>

#include "core/low_discrepancy.h"
#include "shade/plain_view.h"
#include "support/motions.h"

namespace overfly {
namespace {

// Film points and times all over the picture.
SkyNodes asked_all_over(std::uint32_t set) {
    SkyNodes nodes;
    for (std::size_t i = 0; i < SkyNodes::kSize; ++i) {
        const auto p = low_discrepancy_point(set, static_cast<std::uint32_t>(i));
        nodes.x[i] = 2.0 * p[0] - 1.0;
        nodes.y[i] = 1.2 * p[1] - 0.6;
        nodes.u[i] = p[2];
    }
    return nodes;
}

void expect_near(Rgb found, Rgb expected, float tolerance) {
    EXPECT_NEAR(found.r, expected.r, tolerance);
    EXPECT_NEAR(found.g, expected.g, tolerance);
    EXPECT_NEAR(found.b, expected.b, tolerance);
}

class SkyNodesLooking : public ::testing::TestWithParam<double> {};

TEST_P(SkyNodesLooking, SeeWhatEachWouldByItself) {
    const testing::PlainView plain;
    const double pitch_rad = GetParam();
    const MotionPiece scene = testing::HandMotion{{0, 0, 4000}, {90, 30, 5}, 0.3, pitch_rad, 0.2}.piece();
    for (std::uint32_t set = 0; set < 20; ++set) {
        SkyNodes nodes = asked_all_over(set);
        look_at_sky(scene, plain.day, plain.light, nodes, SkyNodes::kSize);
        for (std::size_t i = 0; i < SkyNodes::kSize; ++i) {
            const Point<Scene> from = scene.origin_at(nodes.u[i]);
            const Vector<Scene> direction = normalized(scene.direction_at(nodes.u[i], nodes.x[i], nodes.y[i]));
            const auto distance_m = plain.light.far().distance_m(from, direction);
            EXPECT_EQ(nodes.is_earth[i], distance_m ? 1 : 0) << i;
            const double lowest_m = plain.light.lowest_m(), earth_m = plain.light.far().height_m;
            Rgb expected = plain.day.background(direction, up_at(from));
            if (distance_m) {
                expected = plain.day.through_air(plain.light.far().radiance,
                                                 {*distance_m, height_over_ball_m(from) - lowest_m, earth_m - lowest_m},
                                                 direction);
            }
            expect_near(nodes.views.seen(i), expected, 2e-6F);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(UpAndDown, SkyNodesLooking, ::testing::Values(0.7, 0.1, -0.035, -0.2, -1.2));

// Below the Earth's own height there is nothing but sky, wherever one looks.
TEST(SkyNodes, SeeNoEarthFromBelowIt) {
    const testing::PlainView plain;
    SkyNodes nodes = asked_all_over(1);
    const double below_m = plain.light.far().height_m - 50.0;
    const MotionPiece scene = testing::HandMotion{{0, 0, below_m}, {0, 0, 0}, 0.0, -0.5, 0.0}.piece();
    look_at_sky(scene, plain.day, plain.light, nodes, SkyNodes::kSize);
    for (const std::int32_t is_earth : nodes.is_earth) EXPECT_EQ(is_earth, 0);
}

}  // namespace
}  // namespace overfly
