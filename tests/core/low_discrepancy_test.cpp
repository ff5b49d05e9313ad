#include "core/low_discrepancy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace overfly {
namespace {

// The law of the header: any power-of-two run from index 0 has one point in every elementary box of the first two axes.
TEST(LowDiscrepancy, FirstTwoDimensionsAreANet) {
    constexpr std::uint32_t kLog2 = 6;
    constexpr std::uint32_t kCount = 1U << kLog2;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        for (std::uint32_t split = 0; split <= kLog2; ++split) {
            const double columns = std::ldexp(1.0, static_cast<int>(split));
            const double rows = std::ldexp(1.0, static_cast<int>(kLog2 - split));
            std::set<std::pair<int, int>> boxes;
            for (std::uint32_t i = 0; i < kCount; ++i) {
                const auto p = low_discrepancy_point(seed, i);
                boxes.insert({static_cast<int>(p[0] * columns), static_cast<int>(p[1] * rows)});
            }
            EXPECT_EQ(boxes.size(), kCount) << "seed " << seed << " split " << split;
        }
    }
}

// Each axis alone is stratified, time (the third) included.
TEST(LowDiscrepancy, EveryAxisIsStratified) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            std::set<int> strata;
            for (std::uint32_t i = 0; i < 64; ++i)
                strata.insert(static_cast<int>(64.0 * low_discrepancy_point(seed, i)[axis]));
            EXPECT_EQ(strata.size(), 64U) << "seed " << seed << " axis " << axis;
        }
    }
}

TEST(LowDiscrepancy, SeedsGiveDifferentPoints) {
    EXPECT_NE(low_discrepancy_point(1, 0), low_discrepancy_point(2, 0));
    EXPECT_EQ(low_discrepancy_point(7, 3), low_discrepancy_point(7, 3));
}

}  // namespace
}  // namespace overfly
