#include "core/polynomial_roots.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/root_laws.h"

namespace overfly {
namespace {

using testing::with_eighths;
using testing::with_roots;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <std::size_t N>
void expect_roots(const Bernstein<N>& b, const std::vector<double>& wanted, double bound = 1e-12) {
    const Roots<N> roots = sign_change_roots<N>(b);
    ASSERT_EQ(roots.count, wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(roots.u[i], wanted[i], bound) << "root " << i;
}

// cos((2 k - 1) pi / 2 n) brought to [0, 1]; the coefficients are (-1)^(n-i) C(2n, 2i) / C(n, i).
template <std::size_t N>
void expect_chebyshev() {
    Bernstein<N> b{};
    long double even = 1;  // C(2N, 2i)
    long double plain = 1;
    for (std::size_t i = 0; i <= N; ++i) {
        b[i] = static_cast<double>(((N - i) % 2 == 0 ? even : -even) / plain);
        const auto left = static_cast<long double>(2 * (N - i));
        const auto taken = static_cast<long double>(2 * i);
        even = even * left * (left - 1) / ((taken + 1) * (taken + 2));
        plain = plain * (left / 2) / (taken / 2 + 1);
    }
    std::vector<double> wanted;
    for (std::size_t k = N; k > 0; --k) {
        const double angle_rad = (static_cast<double>(k) - 0.5) * std::numbers::pi / static_cast<double>(N);
        wanted.push_back(0.5 + 0.5 * std::cos(angle_rad));
    }
    expect_roots<N>(b, wanted);
}

TEST(PolynomialRoots, FindsThoseOfChebyshev) {
    expect_chebyshev<1>();
    expect_chebyshev<2>();
    expect_chebyshev<3>();
    expect_chebyshev<4>();
    expect_chebyshev<5>();
    expect_chebyshev<8>();
    expect_chebyshev<12>();
}

// Wilkinson's polynomial, its roots brought to dyadic places; and how far they may lie is asked of the coefficients as
// they were rounded.
TEST(PolynomialRoots, FindsThoseOfWilkinson) {
    expect_roots<7>(with_eighths<7>({1, 2, 3, 4, 5, 6, 7}), {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875});
    std::array<double, 12> places{};
    for (std::size_t i = 0; i < 12; ++i) places[i] = static_cast<double>(i + 2) / 16.0;
    const Bernstein<12> b = with_roots<12>(places);
    const Roots<12> roots = sign_change_roots<12>(b);
    ASSERT_EQ(roots.count, 12U);
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_NEAR(roots.u[i], places[i], 1e-11);
        EXPECT_TRUE(testing::changes_near<12>(b, roots.u[i], 1e-11)) << "root " << i;
    }
}

TEST(PolynomialRoots, SolvesLinesAndQuadratics) {
    expect_roots<1>({-1.0, 3.0}, {0.25}, 0.0);
    expect_roots<2>({-1.0, 1.0, 3.0}, {0.25}, 1e-16);
    expect_roots<2>({3.0, -5.0, 3.0}, {0.25, 0.75}, 1e-15);
    expect_roots<2>({1.0, 0.0, -1e-300}, {1.0}, 0.0);
    expect_roots<2>({1e-200, -1.0, 1.0}, {5e-201, 2.0 / 3.0}, 1e-15);
}

TEST(PolynomialRoots, LeavesOutRootsOutside) {
    expect_roots<4>(with_roots<4>({-0.5, 0.3, 1.5, 2.0}), {0.3}, 1e-14);
    expect_roots<4>(with_roots<4>({-0.5, -0.25, 1.5, 2.0}), {});
}

TEST(PolynomialRoots, NoneWhereNothingChangesSign) {
    expect_roots<4>({0, 0, 0, 0, 0}, {});
    expect_roots<4>({1, 2, 0, 2, 1}, {});
    expect_roots<12>({}, {});
    expect_roots<1>({0, 1}, {});
}

TEST(PolynomialRoots, NoneWithoutFiniteCoefficients) {
    for (const double bad : {kInfinity, -kInfinity, kNan}) {
        for (std::size_t place = 0; place < 5; ++place) {
            Bernstein<4> b = {1.0, -1.0, 2.0, -3.0, 1.0};
            b[place] = bad;
            expect_roots<4>(b, {});
        }
        expect_roots<1>({bad, -1.0}, {});
        expect_roots<2>({1.0, bad, -1.0}, {});
    }
}

// A root at an end is no change of sign; one beside it is, whatever else lies at the end.
TEST(PolynomialRoots, DividesOutTheEnds) {
    expect_roots<4>(with_eighths<4>({0, 3, -8, 16}), {0.375}, 1e-15);
    expect_roots<6>(with_eighths<6>({0, 0, 0, 3, 8, 8}), {0.375});
    expect_roots<6>(with_eighths<6>({0, 0, 3, 5, 8, 8}), {0.375, 0.625});
    expect_roots<3>(with_eighths<3>({0, 0, 8}), {});
    // The least numbers that are not zero make a root beside the end.
    constexpr double kLeast = std::numeric_limits<double>::denorm_min();
    expect_roots<3>({-kLeast, 1.0, 1.0, 1.0}, {0.0}, 1e-300);
    expect_roots<4>({-kLeast, 1.0, 1.0, 1.0, -kLeast}, {0.0, 1.0}, 1e-300);
    expect_roots<2>({kLeast, 1.0, -1.0}, {2.0 / 3.0}, 1e-15);
    expect_roots<4>({kLeast, 0.5, 0.5, 0.5, -2.0}, {2.0 / 3.0}, 1e-15);  // u (2 - 3 u) (1 + u^2)
}

TEST(PolynomialRoots, LeadingCoefficientsMayVanish) {
    // 4 u - 1 and (4 u - 1)(4 u - 3), raised to higher degrees.
    expect_roots<4>({-1.0, 0.0, 1.0, 2.0, 3.0}, {0.25}, 1e-15);
    const Bernstein<4> quadratic = {3.0, -1.0, -7.0 / 3.0, -1.0, 3.0};
    expect_roots<4>(quadratic, {0.25, 0.75}, 1e-14);
    Bernstein<12> twelve{};
    for (std::size_t i = 0; i <= 12; ++i) twelve[i] = 4.0 * static_cast<double>(i) / 12.0 - 1.0;
    expect_roots<12>(twelve, {0.25}, 1e-14);
}

TEST(PolynomialRoots, EvenRootsAreLeftOutAndOddOnesCountOnce) {
    expect_roots<4>(with_eighths<4>({2, 2, 24, 32}), {});
    expect_roots<4>(with_eighths<4>({2, 2, 6, 6}), {});
    expect_roots<3>(with_eighths<3>({2, 2, 6}), {0.75});
    expect_roots<3>(with_eighths<3>({3, 3, 3}), {0.375}, 1e-5);
    expect_roots<5>(with_eighths<5>({2, 2, 4, 6, 6}), {0.5});
    expect_roots<12>(with_eighths<12>({1, 1, 2, 3, 3, 4, 4, 4, 4, 5, 7, 7}), {0.25, 0.625}, 1e-9);
}

// A parabola that passes zero by `depth` at its turn: none or two, and two as soon as it is certain.
TEST(PolynomialRoots, NearDoublePairsComeAsTwoOrNone) {
    bool was_two = false;
    for (double depth = 1e-18; depth < 1e-3; depth *= 1.07) {
        const Bernstein<4> b = {1.0 - depth, -depth, -1.0 / 3.0 - depth, -depth, 1.0 - depth};
        const Roots<4> roots = sign_change_roots<4>(b);
        ASSERT_TRUE(roots.count == 0 || roots.count == 2) << depth;
        ASSERT_EQ(testing::broken_law<4>(b, roots, {0.5}), "") << depth;
        ASSERT_TRUE(roots.count == 2 || depth <= 4 * kSignCertain) << depth;
        ASSERT_TRUE(roots.count == 0 || depth >= kTouch) << depth;
        ASSERT_TRUE(roots.count == 2 || !was_two) << depth;
        was_two = roots.count == 2;
        if (!was_two) continue;
        ASSERT_NEAR(roots.u[1] - roots.u[0], std::sqrt(depth), 1e-15 / std::sqrt(depth)) << depth;
    }
    EXPECT_TRUE(was_two);
}

TEST(PolynomialRoots, MagnitudeDoesNotMatter) {
    const std::array<double, 6> places = {0.125, 0.25, 0.375, 0.5, 0.625, 0.875};
    const Roots<6> wanted = sign_change_roots<6>(with_roots<6>(places));
    ASSERT_EQ(wanted.count, 6U);
    for (int exponent = -960; exponent <= 1023; ++exponent) {
        Bernstein<6> b = with_roots<6>(places);
        for (double& c : b) c = std::ldexp(-c, exponent);
        const Roots<6> roots = sign_change_roots<6>(b);
        ASSERT_EQ(roots.count, wanted.count) << exponent;
        ASSERT_EQ(roots.u, wanted.u) << exponent;
    }
    for (int exponent = -300; exponent <= 300; ++exponent) {
        Bernstein<6> b = with_roots<6>(places);
        for (double& c : b) c *= std::pow(10.0, exponent);
        expect_roots<6>(b, {places.begin(), places.end()});
    }
    constexpr double kMost = std::numeric_limits<double>::max();
    expect_roots<4>({-kMost, -kMost / 2, 0.0, kMost / 2, kMost}, {0.5}, 1e-16);
    constexpr double kLeast = std::numeric_limits<double>::denorm_min();
    expect_roots<4>({3 * kLeast, 0.0, -kLeast, 0.0, 3 * kLeast}, {}, 0.0);
    expect_roots<3>({kLeast, -kLeast, kLeast, -kLeast}, {0.5}, 1e-5);
}

}  // namespace
}  // namespace overfly
