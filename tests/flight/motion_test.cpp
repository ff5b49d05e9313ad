#include "flight/motion.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "flights.h"

namespace overfly {
namespace {

using flights::deg;
using flights::keyframe;
using flights::looking;
using flights::path;
using flights::place;

struct Flight {
    std::string name;
    std::vector<Keyframe> keyframes;
    double distance_to_ground_m = 100.0;
};

std::vector<Flight> flights_of_all_kinds() {
    const FlightPlace here = place(0.0, 0.0, 500.0), there = place(0.005, 0.0, 500.0), below = place(0.003, 0.002, 0.0);
    const Attitude east{deg(90.0), deg(-10.0), deg(0.0)};
    std::vector<Keyframe> orbit;
    for (int i = 0; i <= 8; ++i) {
        const double angle = i * std::numbers::pi / 4.0;
        orbit.push_back(
            looking(1.5 * i, place(0.003 + 0.004 * std::cos(angle), 0.004 * std::sin(angle), 300.0), below));
    }
    return {
        {"level", {keyframe(0, here, east), keyframe(10, there, east)}},
        {"low", flights::varied(), 2.0},
        {"dive",
         {keyframe(0, here, east), keyframe(2, place(0.001, 0, 480), {deg(90.0), deg(-60.0), deg(0.0)}),
          keyframe(4, place(0.0015, 0, 100), {deg(90.0), deg(0.0), deg(0.0)})},
         30.0},
        {"fast pan",
         {keyframe(0, here, {deg(0.0), deg(0.0), deg(0.0)}), keyframe(1, here, {deg(170.0), deg(0.0), deg(0.0)}),
          keyframe(2, here, {deg(300.0), deg(-20.0), deg(0.0)})}},
        {"barrel roll", {keyframe(0, here, east), keyframe(3, there, {deg(90.0), deg(-10.0), deg(360.0)})}},
        {"hover", {keyframe(0, here, east), keyframe(5, here, east)}},
        {"straight down",
         {keyframe(0, here, {deg(0.0), deg(-90.0), deg(0.0)}), keyframe(5, there, {deg(60.0), deg(-90.0), deg(0.0)})}},
        {"zoom", {keyframe(0, here, east, 100.0), keyframe(1, there, east, 10.0), keyframe(3, there, east, 60.0)}},
        {"orbit", orbit, 80.0},
        {"varied", flights::varied(), 50.0},
        {"sky", flights::varied(), std::numeric_limits<double>::infinity()},
    };
}

Surroundings at_distance(double distance_m) {
    Surroundings world = flights::bare_ellipsoid();
    world.distance_to_ground_m = [distance_m](Point<Scene>) { return distance_m; };
    return world;
}

// Where a piece sees a point: solves origin + s (x right + y down + view) = point for x, y.
std::pair<double, double> film_point(const MotionPiece& piece, double u, Point<Scene> point) {
    const Vector<Scene> p = point - piece.origin_at(u), r = piece.right.at(u), d = piece.down.at(u),
                        v = piece.view.at(u);
    const double volume_v = dot(p, cross(r, d));
    return {dot(p, cross(d, v)) / volume_v, dot(p, cross(v, r)) / volume_v};
}

TEST(Motion, ImagesEveryGroundPointWithinTheBound) {
    constexpr unsigned kSeed = 3;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const MotionOptions options;
    const double aspect = static_cast<double>(options.height_px) / options.width_px;
    for (const Flight& flight : flights_of_all_kinds()) {
        const CameraPath camera = path(flight.keyframes);
        const TimeRange when{camera.times().begin_s - 0.02, camera.times().end_s + 0.02};
        const Motion motion = fit_motion(camera, when, at_distance(flight.distance_to_ground_m), options);
        double largest_px = 0.0;
        for (int i = 0; i < 4000; ++i) {
            const double t = when.begin_s + unit(random) * when.duration_s();
            // Half the points on the picture's edge, a third of them at the nearest ground.
            double x = 2.0 * unit(random) - 1.0, y = aspect * (2.0 * unit(random) - 1.0);
            if (i % 2 == 0) (i % 4 == 0 ? x : y) = i % 4 == 0 ? std::copysign(1.0, x) : std::copysign(aspect, y);
            const double nearest_m = std::min(flight.distance_to_ground_m, 1e7);
            const double ray_m = i % 3 == 0 ? nearest_m : nearest_m / std::max(1e-4, unit(random));
            const CameraPose pose = camera.pose_at(t);
            const Vector<Scene> ray = x * pose.tan_half_fov * pose.orientation.x +
                                      y * pose.tan_half_fov * pose.orientation.y + pose.orientation.z;
            const MotionPiece& piece = motion.piece_at(t);
            const auto [fx, fy] = film_point(piece, piece.u_at(t), pose.position + ray_m * normalized(ray));
            largest_px = std::max(largest_px, std::hypot(fx - x, fy - y) * options.width_px / 2.0);
        }
        EXPECT_LE(largest_px, options.bound_px) << flight.name << ", seed " << kSeed;
        EXPECT_LE(motion.largest_error_px, options.bound_px) << flight.name;
        // Measured, not guessed: random points find nearly what the fit says it found.
        if (motion.largest_error_px > 1e-3) {
            EXPECT_GT(largest_px, 0.5 * motion.largest_error_px) << flight.name;
        }
    }
}

TEST(Motion, IsContinuousAndWithoutGaps) {
    for (const Flight& flight : flights_of_all_kinds()) {
        const CameraPath camera = path(flight.keyframes);
        const Motion motion = fit_motion(camera, camera.times(), at_distance(flight.distance_to_ground_m), {});
        EXPECT_EQ(motion.times(), camera.times());
        for (std::size_t i = 0; i + 1 < motion.pieces.size(); ++i) {
            const MotionPiece &a = motion.pieces[i], &b = motion.pieces[i + 1];
            EXPECT_EQ(a.when.end_s, b.when.begin_s);
            EXPECT_LT(a.when.duration_s(), MotionOptions{}.longest_piece_s * (1.0 + 1e-5));
            EXPECT_LT(distance(a.origin_at(1.0), b.origin_at(0.0)), 1e-9);
            EXPECT_LT(length(a.direction_at(1.0, 1.0, -0.5) - b.direction_at(0.0, 1.0, -0.5)), 1e-9);
        }
    }
}

TEST(Motion, FindsPiecesByTime) {
    const CameraPath camera = path(flights::varied());
    const Motion motion = fit_motion(camera, camera.times(), at_distance(50.0), {});
    for (const MotionPiece& piece : motion.pieces) {
        EXPECT_EQ(&motion.piece_at(piece.when.begin_s), &piece);
        EXPECT_EQ(&motion.piece_at(piece.when.centre_s()), &piece);
        const auto over = motion.pieces_over({piece.when.centre_s(), piece.when.centre_s()});
        ASSERT_EQ(over.size(), 1U);
        EXPECT_EQ(&over.front(), &piece);
    }
    EXPECT_EQ(&motion.piece_at(-1.0), &motion.pieces.front());
    EXPECT_EQ(&motion.piece_at(100.0), &motion.pieces.back());
    EXPECT_EQ(motion.pieces_over(camera.times()).size(), motion.pieces.size());
    EXPECT_TRUE(motion.pieces_over({20.0, 21.0}).empty());
}

TEST(Motion, ATurnOverTheTargetEnds) {
    const FlightPlace target = place(7.0, 46.0, 0.0);
    const CameraPath camera =
        path({looking(0.0, place(7.0, 45.99, 1000.0), target), looking(7.0, place(7.0, 46.005, 1000.0), target)});
    const Motion motion = fit_motion(camera, camera.times(), at_distance(1000.0), {});
    EXPECT_LT(motion.pieces.size(), 2000U);
    for (const MotionPiece& piece : motion.pieces)
        EXPECT_TRUE(std::isfinite(length(piece.direction_at(0.5, 1.0, 0.5))));
}

TEST(Motion, CameraOnTheGroundIsFitted) {
    const CameraPath camera = path(flights::varied());
    const Motion motion = fit_motion(camera, camera.times(), at_distance(0.0), {});
    EXPECT_LE(motion.largest_error_px, motion.bound_px);
}

TEST(Motion, IsFittedQuicklyAndInFewPieces) {
    const CameraPath camera = path(flights::varied());
    const auto begin = std::chrono::steady_clock::now();
    const Motion motion = fit_motion(camera, {0.0, 10.0}, at_distance(50.0), {});
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_LE(motion.pieces.size(), 215U);  // 213 when pinned: the least squares are worth a few percent
    EXPECT_LT(took.count(), 5.0);           // 0.01 s alone on a machine; sanitizers and neighbours are slower
}

}  // namespace
}  // namespace overfly
