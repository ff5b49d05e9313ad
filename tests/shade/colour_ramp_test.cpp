#include "shade/colour_ramp.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

TEST(ColourRamp, IsLinearBetweenStopsAndConstantBeyond) {
    const ColourRamp ramp{{{100, {0, 0, 0}}, {300, {1, 0.5F, 0}}}};
    EXPECT_EQ(ramp.at(-50), (Rgb{0, 0, 0}));
    EXPECT_EQ(ramp.at(100), (Rgb{0, 0, 0}));
    EXPECT_EQ(ramp.at(150), (Rgb{0.25F, 0.125F, 0}));
    EXPECT_EQ(ramp.at(300), (Rgb{1, 0.5F, 0}));
    EXPECT_EQ(ramp.at(9000), (Rgb{1, 0.5F, 0}));
}

TEST(ColourRamp, StepsToTheUpperColour) {
    const ColourRamp ramp{{{0, {1, 0, 0}}, {10, {1, 0, 0}}, {10, {0, 0, 1}}, {20, {0, 0, 1}}}};
    EXPECT_EQ(ramp.at(9.999F), (Rgb{1, 0, 0}));
    EXPECT_EQ(ramp.at(10), (Rgb{0, 0, 1}));
}

TEST(ColourRamp, OneStopIsOneColour) {
    const ColourRamp ramp{{{0, {1, 2, 3}}}};
    for (const float elevation_m : {-1.0F, 0.0F, 1.0F}) EXPECT_EQ(ramp.at(elevation_m), (Rgb{1, 2, 3}));
}

TEST(ColourRamp, WithoutSteepColoursTheSlopeMakesNoDifference) {
    const ColourRamp ramp{{{100, {0, 0, 0}}, {300, {1, 0.5F, 0}}}};
    for (const float slope_cos : {1.0F, 0.9F, 0.5F, 0.0F}) EXPECT_EQ(ramp.at(150, slope_cos), ramp.at(150));
    EXPECT_EQ(ramp.stray_m, 0.0F);
}

TEST(ColourRamp, GoesOverToItsSteepColours) {
    const ColourRamp ramp{.stops = {{0, {1, 1, 1}}}, .steep = {{0, {0, 0, 0}}}};
    EXPECT_EQ(ramp.at(0, ramp.all_level_cos), (Rgb{1, 1, 1}));
    EXPECT_EQ(ramp.at(0, ramp.all_steep_cos), (Rgb{0, 0, 0}));
    EXPECT_NEAR(ramp.at(0, 0.5F * (ramp.all_level_cos + ramp.all_steep_cos)).g, 0.5F, 1e-6F);
}

}  // namespace
}  // namespace overfly
