#include "flight/image_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace overfly {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const RayFrame kCamera{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}};

TEST(ImageError, OfEqualCamerasIsZero) { EXPECT_EQ(image_error(kCamera, kCamera, 0.5, {10.0}), 0.0); }

TEST(ImageError, OfAMoveIsItsParallaxAtTheNearestGround) {
    RayFrame moved = kCamera;
    moved.origin = {0.1, 0, 0};
    // A point 10 m along the middle ray has the planar depth 10 m, and along the corner's, sqrt(1 + 1 + 1/4) shorter.
    EXPECT_NEAR(image_error(kCamera, moved, 0.5, {10.0}), 0.1 / 10.0 * std::sqrt(2.25), 1e-12);
    EXPECT_NEAR(image_error(kCamera, moved, 0.5, {kInfinity}), 0.0, 1e-15);
}

TEST(ImageError, OfATurnIsLargestInTheCorners) {
    const double a = 1e-3;
    RayFrame turned = kCamera;
    turned.right = {std::cos(a), std::sin(a), 0};
    turned.view = {-std::sin(a), std::cos(a), 0};
    // The film point tan(b) of the direction b moves to tan(b + a).
    const double at_edge = std::tan(std::atan(1.0) + a) - 1.0;
    EXPECT_GE(image_error(kCamera, turned, 0.5, {kInfinity}), at_edge);
    EXPECT_LT(image_error(kCamera, turned, 0.5, {kInfinity}), 1.2 * at_edge);
}

TEST(ImageError, OfACameraThatLooksAwayIsInfinite) {
    RayFrame away = kCamera;
    away.view = -away.view;
    EXPECT_EQ(image_error(kCamera, away, 0.5, {10.0}), kInfinity);
}

}  // namespace
}  // namespace overfly
