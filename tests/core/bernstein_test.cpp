#include "core/bernstein.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

TEST(Bernstein, ProductMatchesItsFactors) {
    const Bernstein<2> a = {1.0, -2.0, 3.0};
    const Bernstein<2> b = {-1.0, 0.5, 2.0};
    for (const double u : {0.0, 0.1, 0.5, 0.77, 1.0}) {
        EXPECT_NEAR(value_at<4>(a * b, u), value_at<2>(a, u) * value_at<2>(b, u), 1e-14);
    }
}

TEST(Bernstein, ProductsOfAnyDegrees) {
    const Bernstein<4> a = {1.0, -2.0, 0.5, 3.0, -0.7};
    const Bernstein<2> b = {-0.3, 4.0, 1.0};
    const Bernstein<0> c = {-2.5};
    for (const double u : {0.0, 0.2, 0.5, 0.9, 1.0}) {
        const double of_both = value_at<4>(a, u) * value_at<2>(b, u);
        EXPECT_NEAR(value_at<6>(a * b, u), of_both, 1e-14);
        EXPECT_NEAR(value_at<6>(b * a, u), of_both, 1e-14);
        EXPECT_NEAR(value_at<8>(a * b * b, u), of_both * value_at<2>(b, u), 1e-13);
        EXPECT_NEAR(value_at<4>(c * a, u), -2.5 * value_at<4>(a, u), 1e-14);
    }
}

TEST(Bernstein, QuadraticOverAStretch) {
    const Bernstein<2> b = quadratic_over(1.0, -3.0, 2.0, 0.25, 1.5);
    for (const double part : {0.0, 0.3, 1.0}) {
        const double u = 0.25 + 1.25 * part;
        EXPECT_NEAR(value_at<2>(b, part), 1.0 - 3.0 * u + 2.0 * u * u, 1e-14);
    }
}

TEST(Bernstein, MonomialsAreTheSamePolynomial) {
    const Bernstein<4> b = {1.0, -2.0, 3.0, 0.5, -1.0};
    const std::array<double, 5> c = monomials<4>(b);
    for (const double u : {0.0, 0.1, 0.5, 0.77, 1.0}) {
        EXPECT_NEAR(c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * c[4]))), value_at<4>(b, u), 1e-13);
    }
}

TEST(Bernstein, DerivativeIsTheSlope) {
    const Bernstein<4> b = {1.0, -2.0, 3.0, 0.5, -1.0};
    constexpr double kStep = 1e-5;
    for (const double u : {0.1, 0.5, 0.77}) {
        const double slope = (value_at<4>(b, u + kStep) - value_at<4>(b, u - kStep)) / (2 * kStep);
        EXPECT_NEAR(value_at<3>(derivative<4>(b), u), slope, 1e-8);
    }
}

TEST(Bernstein, CountsSignChangesWithoutZeros) {
    EXPECT_EQ(sign_changes<4>({1, 0, -1, 0, 2}), 2);
    EXPECT_EQ(sign_changes<4>({0, 1, 0, 2, 0}), 0);
    EXPECT_EQ(sign_changes<4>({0, 0, 0, 0, 0}), 0);
}

TEST(Bernstein, DividesOutRootsAtTheEnds) {
    const Bernstein<3> b = {0.0, 1.0, -2.0, 4.0};
    const Bernstein<3> c = {4.0, -2.0, 1.0, 0.0};
    for (const double u : {0.1, 0.5, 0.77}) {
        EXPECT_NEAR(u * value_at<2>(divided_by_u<3>(b), u), value_at<3>(b, u), 1e-14);
        EXPECT_NEAR((1 - u) * value_at<2>(divided_by_1_minus_u<3>(c), u), value_at<3>(c, u), 1e-14);
    }
}

}  // namespace
}  // namespace overfly
