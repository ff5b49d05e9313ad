#include "shade/hypsometric.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace overfly {
namespace {

float brightness(Rgb c) { return 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b; }

TEST(Hypsometric, StopsRiseFromTheLowestToTheHighestGround) {
    for (const auto& [lowest_m, highest_m] : {std::pair{2070.0F, 4243.0F}, {-400.0F, 8800.0F}, {12.0F, 12.0F}}) {
        const ColourRamp ramp = hypsometric_ramp(lowest_m, highest_m);
        for (const auto& stops : {ramp.stops, ramp.steep}) {
            ASSERT_GE(stops.size(), 2U);
            EXPECT_EQ(stops.front().elevation_m, lowest_m);
            EXPECT_LE(stops.back().elevation_m, std::max(highest_m, lowest_m + 1.0F));
            for (std::size_t i = 1; i < stops.size(); ++i) EXPECT_LT(stops[i - 1].elevation_m, stops[i].elevation_m);
        }
    }
}

TEST(Hypsometric, ReflectsNoMoreThanSnowAndNoLessThanForest) {
    const ColourRamp ramp = hypsometric_ramp(0.0F, 1000.0F);
    for (const float slope_cos : {1.0F, 0.9F, 0.5F}) {
        for (float elevation_m = 0.0F; elevation_m <= 1000.0F; elevation_m += 1.0F) {
            const float b = brightness(ramp.at(elevation_m, slope_cos));
            EXPECT_GT(b, 0.03F);
            EXPECT_LT(b, 0.8F);
        }
    }
}

TEST(Hypsometric, SnowLiesOnGentleHighGround) {
    const ColourRamp ramp = hypsometric_ramp(0.0F, 1000.0F);
    const float snow = brightness(ramp.at(1000.0F, 1.0F));
    EXPECT_GT(snow, 2.0F * brightness(ramp.at(800.0F, 1.0F)));
    EXPECT_GT(snow, 1.5F * brightness(ramp.at(1000.0F, 0.7F)));
}

}  // namespace
}  // namespace overfly
