#include "flight/exposure.h"

#include <gtest/gtest.h>

#include <vector>

namespace overfly {
namespace {

using Shape = ShutterCurve::Shape;

std::vector<ShutterCurve> all_curves() {
    std::vector<ShutterCurve> curves = {{}};
    for (const Shape shape : {Shape::Trapezoid, Shape::Smooth}) {
        for (const double ramp : {0.01, 0.25, 0.4, 0.5}) curves.push_back({shape, ramp});
    }
    return curves;
}

constexpr double kRounding = 1e-12;

// The midpoint rule with so many steps is off by less than (slope's growth) / 24 / steps^2.
TEST(ShutterCurve, TheShareIsTheIntegralOfTheOpenness) {
    constexpr int kSteps = 20'000;
    for (const ShutterCurve& curve : all_curves()) {
        double sum = 0.0;
        for (int k = 0; k < kSteps; ++k) {
            sum += curve.openness((k + 0.5) / kSteps) / kSteps;
            EXPECT_NEAR(curve.share_until((k + 1.0) / kSteps), sum, 2e-6);
        }
        EXPECT_NEAR(sum, 1.0, 2e-6);
    }
}

TEST(ShutterCurve, IsSymmetricAndEndsWhereItShould) {
    for (const ShutterCurve& curve : all_curves()) {
        EXPECT_EQ(curve.share_until(0.0), 0.0);
        EXPECT_EQ(curve.share_until(-0.5), 0.0);
        EXPECT_EQ(curve.share_until(1.0), 1.0);
        EXPECT_EQ(curve.share_until(1.5), 1.0);
        EXPECT_NEAR(curve.share_until(0.5), 0.5, kRounding);
        for (double s = 0.0; s <= 1.0; s += 0.013)
            EXPECT_NEAR(curve.share_until(s) + curve.share_until(1.0 - s), 1.0, kRounding);
    }
}

TEST(ShutterCurve, KnowsWhenAShareHasComeThrough) {
    for (const ShutterCurve& curve : all_curves()) {
        for (int k = 0; k <= 1000; ++k) {
            const double share = k / 1000.0, part = curve.part_until(share);
            EXPECT_NEAR(curve.share_until(part), share, kRounding) << curve.ramp;
        }
        EXPECT_NEAR(curve.share_until(curve.part_until(1e-9)), 1e-9, kRounding);
    }
}

TEST(ShutterCurve, OpensInItsRamp) {
    const ShutterCurve trapezoid = {Shape::Trapezoid, 0.25}, smooth = {Shape::Smooth, 0.25};
    for (const ShutterCurve& curve : {trapezoid, smooth}) {
        EXPECT_EQ(curve.openness(0.0), 0.0);
        EXPECT_NEAR(curve.openness(0.125), 0.5 / 0.75, kRounding);
        EXPECT_NEAR(curve.openness(0.5), 1.0 / 0.75, kRounding);
    }
    EXPECT_NEAR(trapezoid.openness(0.0625), 0.25 / 0.75, kRounding);
    EXPECT_LT(smooth.openness(0.0625), trapezoid.openness(0.0625));
}

TEST(Exposure, PartsAddUpToOne) {
    for (const ShutterCurve& curve : all_curves()) {
        const Exposure exposure = {{2.0, 2.02}, curve};
        double sum = 0.0;
        for (int k = 0; k < 7; ++k) sum += exposure.share_of({2.0 + 0.02 * k / 7, 2.0 + 0.02 * (k + 1) / 7});
        EXPECT_NEAR(sum, 1.0, 1e-10);
        EXPECT_NEAR(exposure.time_at(0.5), 2.01, kRounding);
    }
}

}  // namespace
}  // namespace overfly
