#include "shade/patchiness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace overfly {
namespace {

TEST(Patchiness, FillsItsRangeAroundZero) {
    float lowest = 0.0F;
    float highest = 0.0F;
    double sum = 0.0;
    constexpr int kSide = 300;
    for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j) {
            const float p = patchiness({173.0 * (i - 150), 173.0 * (j - 150), 0.0});
            ASSERT_LE(std::abs(p), 1.0F);
            lowest = std::min(lowest, p);
            highest = std::max(highest, p);
            sum += p;
        }
    }
    EXPECT_LT(lowest, -0.7F);
    EXPECT_GT(highest, 0.7F);
    EXPECT_NEAR(sum / (kSide * kSide), 0.0, 0.05);
}

TEST(Patchiness, IsSmoothAcrossItsLattice) {
    for (double x = -1500.0; x < 1500.0; x += 7.0) {
        // The steepest that the smooth steps allow: 1.5 times two amplitudes over a lattice's side.
        EXPECT_LE(std::abs(patchiness({x + 1.0, 40.0, 0.0}) - patchiness({x, 40.0, 0.0})), 0.009F) << x;
    }
}

}  // namespace
}  // namespace overfly
