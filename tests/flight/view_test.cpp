#include "flight/view.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "flight/motion.h"

namespace overfly {
namespace {

RayFrame camera_at(double t) { return {{10.0 * t, 3.0 * t * t, 100.0}, {0.5, 0, 0}, {0, 0, -0.5}, {0, 1, 0}}; }

// A body 5 m across, 200 m in front of the camera, that turns about itself.
Transform<Scene, Body> spinning(double t, double turns_per_s) {
    const double a = 2.0 * std::numbers::pi * turns_per_s * t;
    return {{{std::cos(a), std::sin(a), 0}, {-std::sin(a), std::cos(a), 0}, {0, 0, 1}}, {5.0 * t, 200.0, 95.0}};
}

struct Film {
    double x = 0.0, y = 0.0;
};

Film film_of(const RayFrame& rays, Point<Scene> p) {
    const Vector<Scene> to = p - rays.origin;
    const Vector<Scene> a = cross(rays.down, rays.view), b = cross(rays.view, rays.right),
                        c = cross(rays.right, rays.down);
    return {dot(a, to) / dot(c, to), dot(b, to) / dot(c, to)};
}

TEST(View, OfABodyThatSpinsIsImagedWithinTheBound) {
    MotionOptions options;
    for (const double turns_per_s : {0.0, 0.3, 5.0}) {
        const auto pose_at = [&](double t) { return spinning(t, turns_per_s); };
        const View view = {[&](double t) { return seen_from(pose_at(t), camera_at(t)); },
                           [](double, Point<Scene> origin) {
                               const double middle_m = distance(origin, {});
                               return Reach{middle_m - 5.0, middle_m + 5.0};
                           },
                           [&](double t) {
                               return seen_from(pose_at(t), Vector<Scene>{0.6, 0.0, 0.8});
                           }};
        const std::array cuts = {0.0, 0.25, 1.0};
        const Motion motion = fit_motion(view, cuts, options);
        EXPECT_LE(motion.largest_error_px, options.bound_px);
        double worst_px = 0.0, worst_sun = 0.0;
        for (int k = 0; k <= 2000; ++k) {
            const double t = k / 2000.0;
            const MotionPiece& piece = motion.piece_at(t);
            const double u = piece.u_at(t);
            const RayFrame fitted = {piece.origin_at(u), piece.right.at(u), piece.down.at(u), piece.view.at(u)};
            worst_sun = std::max(worst_sun, length(piece.to_sun.at(u) - view.to_sun_at(t)));
            for (const Point<Scene> p : {Point<Scene>{5, 0, 0}, Point<Scene>{0, -5, 0}, Point<Scene>{0, 3, 4}}) {
                const Film is = film_of(fitted, p), should = film_of(view.rays_at(t), p);
                worst_px = std::max(worst_px, 0.5 * options.width_px * std::hypot(is.x - should.x, is.y - should.y));
            }
        }
        EXPECT_LE(worst_px, options.bound_px) << turns_per_s;
        EXPECT_LE(worst_sun, options.bound_px / (0.5 * options.width_px) * 0.5) << turns_per_s;
    }
}

TEST(View, OfABodyIsThatOfTheSceneCarriedAlong) {
    const Transform<Scene, Body> pose = spinning(0.17, 1.0);
    const RayFrame rays = camera_at(0.17);
    const RayFrame seen = seen_from(pose, rays);
    const Point<Body> p = {1.0, 2.0, 3.0};
    const Film in_scene_film = film_of(rays, pose * p);
    const Film own_film = film_of(seen, {p.x, p.y, p.z});
    EXPECT_NEAR(in_scene_film.x, own_film.x, 1e-12);
    EXPECT_NEAR(in_scene_film.y, own_film.y, 1e-12);
}

TEST(View, InAMirrorSeesThePointWhereItIsMirrored) {
    const FixedPlane plane = {{0, 0, 40.0}, normalized(Vector<Scene>{0.1, -0.2, 1.0})};
    const RayFrame rays = camera_at(0.4);
    const RayFrame behind = mirrored(rays, plane);
    const Point<Scene> p = {20.0, 300.0, 70.0};
    const Point<Scene> image = p - 2.0 * dot(plane.normal, p - plane.on) * plane.normal;
    const Film of_image = film_of(rays, image), of_point = film_of(behind, p);
    EXPECT_NEAR(of_image.x, of_point.x, 1e-12);
    EXPECT_NEAR(of_image.y, of_point.y, 1e-12);
}

}  // namespace
}  // namespace overfly
