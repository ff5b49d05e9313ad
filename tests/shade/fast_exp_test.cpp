#include "shade/fast_exp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overfly {
namespace {

TEST(FastExp, IsOneAtZero) { EXPECT_EQ(fast_exp(0.0F), 1.0F); }

TEST(FastExp, KeepsItsBound) {
    for (float x = 0.0F; x >= -87.0F; x -= 0.00137F) {
        const double exact = std::exp(static_cast<double>(x));
        ASSERT_NEAR(fast_exp(x) / exact, 1.0, 1e-5) << x;
    }
}

TEST(FastExp, FadesOutBelow) {
    for (const float x : {-87.5F, -1e3F, -1e30F, -INFINITY}) {
        EXPECT_GE(fast_exp(x), 0.0F);
        EXPECT_LT(fast_exp(x), 2e-38F);
    }
}

TEST(FastExp, FourAreFourTimesOne) {
    const Float4 four = fast_exp(Float4{-0.1F, -1.0F, -10.0F, -50.0F});
    EXPECT_EQ(four[0], fast_exp(-0.1F));
    EXPECT_EQ(four[1], fast_exp(-1.0F));
    EXPECT_EQ(four[2], fast_exp(-10.0F));
    EXPECT_EQ(four[3], fast_exp(-50.0F));
}

}  // namespace
}  // namespace overfly
