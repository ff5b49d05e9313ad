#include "core/bernstein.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace overfly {
namespace {

// (u - r0)(u - r1)(u - r2)(u - r3) in Bernstein form, by the product of its factors' forms.
Bernstein<4> with_roots(double r0, double r1, double r2, double r3) {
    const auto quadratic = [](double a, double b) {
        return Bernstein<2>{a * b, a * b - 0.5 * (a + b), (1.0 - a) * (1.0 - b)};
    };
    return quadratic(r0, r1) * quadratic(r2, r3);
}

TEST(Bernstein, FindsWellSeparatedRoots) {
    const std::vector<double> wanted = {0.125, 0.25, 0.5, 0.875};
    const Roots<4> roots = sign_change_roots<4>(with_roots(wanted[0], wanted[1], wanted[2], wanted[3]));
    ASSERT_EQ(roots.count, 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(roots.u[i], wanted[i], 1e-12);
}

TEST(Bernstein, LeavesOutRootsOutside) {
    const Roots<4> roots = sign_change_roots<4>(with_roots(-0.5, 0.3, 1.5, 2.0));
    ASSERT_EQ(roots.count, 1U);
    EXPECT_NEAR(roots.u[0], 0.3, 1e-13);
}

TEST(Bernstein, LeavesOutTouchesWithoutACrossing) {
    EXPECT_EQ(sign_change_roots<4>(with_roots(0.25, 0.25, 3.0, 4.0)).count, 0U);
}

TEST(Bernstein, NothingWhereNothingChangesSign) {
    EXPECT_EQ(sign_change_roots<4>({0, 0, 0, 0, 0}).count, 0U);
    EXPECT_EQ(sign_change_roots<4>({1, 2, 0, 2, 1}).count, 0U);
}

TEST(Bernstein, FindsTheLinearRoot) {
    const Roots<1> roots = sign_change_roots<1>({-1.0, 3.0});
    ASSERT_EQ(roots.count, 1U);
    EXPECT_DOUBLE_EQ(roots.u[0], 0.25);
}

// Against a dense scan: never fewer sign changes than the scan sees, of the same parity, each a true zero.
TEST(Bernstein, AgreesWithADenseScan) {
    constexpr unsigned kSeed = 1;
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> coefficient(-1.0, 1.0);
    for (int trial = 0; trial < 100'000; ++trial) {
        Bernstein<4> b{};
        std::ranges::generate(b, [&] { return coefficient(generator); });
        const Roots<4> roots = sign_change_roots<4>(b);
        std::size_t seen = 0;
        double last = b[0];
        for (int i = 1; i <= 64; ++i) {
            const double now = value_at<4>(b, i / 64.0);
            if ((now < 0.0) != (last < 0.0)) ++seen;
            last = now;
        }
        ASSERT_GE(roots.count, seen) << "trial " << trial << " seed " << kSeed;
        ASSERT_EQ((roots.count - seen) % 2, 0U) << "trial " << trial << " seed " << kSeed;
        ASSERT_TRUE(std::is_sorted(roots.begin(), roots.end()));
        for (const double u : roots) ASSERT_NEAR(value_at<4>(b, u), 0.0, 1e-14);
    }
}

TEST(Bernstein, ProductMatchesItsFactors) {
    const Bernstein<2> a = {1.0, -2.0, 3.0};
    const Bernstein<2> b = {-1.0, 0.5, 2.0};
    for (const double u : {0.0, 0.1, 0.5, 0.77, 1.0}) {
        EXPECT_NEAR(value_at<4>(a * b, u), value_at<2>(a, u) * value_at<2>(b, u), 1e-14);
    }
}

}  // namespace
}  // namespace overfly
