#include "flight/closest_approach.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "flight/flights.h"

namespace overfly {
namespace {

using namespace flights;

constexpr PicturePixels kPicture = {960, 540};

// A camera that looks north from (0, 0, 0) and flies 100 m to the east, its lens 90 degrees wide.
Motion eastward() {
    MotionPiece piece;
    piece.when = {0.0, 1.0};
    piece.origin = {{}, {100.0, 0.0, 0.0}, {}};
    piece.right = {{1.0, 0.0, 0.0}, {}, {}};
    piece.down = {{0.0, 0.0, -1.0}, {}, {}};
    piece.view = {{0.0, 1.0, 0.0}, {}, {}};
    return {{piece}, 0.01, 0.0};
}

TEST(ClosestApproach, IsAQuotientOfDistance) {
    const ClosestApproach approach(eastward(), kPicture);
    // In the middle of the picture 480 pixels are a tangent of 1; in a corner 1 + 1 + (540 / 960)^2 as many.
    const double corner = 480.0 * (2.0 + 0.5625 * 0.5625);
    EXPECT_NEAR(approach.pixels_per_metre({50.0, 200.0, 0.0}), corner / 200.0, 1e-9);
    EXPECT_NEAR(approach.pixels_per_metre({-30.0, 40.0, 0.0}), corner / 50.0, 1e-9);
    EXPECT_NEAR(approach.pixels_per_metre({150.0, 0.0, 120.0}, 30.0), corner / 100.0, 1e-9);
    EXPECT_NEAR(approach.pixels_per_metre({50.0, 20.0, 0.0}, 20.0), corner / ClosestApproach::kNearest_m, 1e-6);
}

// Against the pictures of many small steps in all directions, at many times, wherever they come to be in the picture.
TEST(ClosestApproach, NoMetreIsLargerInAnyPicture) {
    const CameraPath flight = path(varied());
    const Motion motion = fit_motion(flight, flight.times(), bare_ellipsoid(), {});
    const ClosestApproach approach(motion, kPicture);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    double largest_share = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const double time_s = flight.times().begin_s + 0.5 * (share(random) + 1.0) * flight.times().duration_s();
        const CameraPose pose = flight.pose_at(time_s);
        const Transform<Camera, Scene> to_camera = pose.camera_from_scene();
        const double depth_m = 400.0 + 350.0 * share(random);
        const double x = share(random), y = 0.5625 * share(random);
        const Point<Camera> seen = {x * pose.tan_half_fov * depth_m, y * pose.tan_half_fov * depth_m, depth_m};
        const Point<Scene> p = inverse(to_camera) * seen;
        const Vector<Scene> step = 0.01 * normalized(Vector<Scene>{share(random), share(random), share(random)});
        const auto film = [&](Point<Camera> q) { return std::pair(q.x / q.z, q.y / q.z); };
        const auto from = film(seen), to = film(to_camera * (p + step));
        const double px = 480.0 / pose.tan_half_fov * std::hypot(to.first - from.first, to.second - from.second);
        largest_share = std::max(largest_share, px / 0.01 / approach.pixels_per_metre(p));
    }
    EXPECT_LE(largest_share, 1.001);
    EXPECT_GT(largest_share, 0.9) << "the bound is worth its name";
}

TEST(ClosestApproach, ABallIsAtLeastAsNearAsAnyOfItsPoints) {
    const CameraPath flight = path(varied());
    const ClosestApproach approach(fit_motion(flight, flight.times(), bare_ellipsoid(), {}), kPicture);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    for (int i = 0; i < 2'000; ++i) {
        const Point<Scene> middle = {1000.0 * share(random), 1000.0 * share(random), 200.0 * share(random)};
        const Vector<Scene> towards = normalized(Vector<Scene>{share(random), share(random), share(random)});
        EXPECT_LE(approach.pixels_per_metre(middle + 99.0 * towards), approach.pixels_per_metre(middle, 100.0));
    }
}

TEST(ClosestApproach, TellsFlightsApart) {
    Motion motion = eastward();
    const std::string text = ClosestApproach(motion, kPicture).text();
    EXPECT_EQ(ClosestApproach(motion, kPicture).text(), text);
    EXPECT_NE(ClosestApproach(motion, {480, 270}).text(), text);
    motion.pieces.front().origin.c1.x += 1e-9;
    EXPECT_NE(ClosestApproach(motion, kPicture).text(), text);
}

}  // namespace
}  // namespace overfly
