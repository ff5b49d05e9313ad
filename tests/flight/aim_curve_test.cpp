#include "flight/aim_curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flight/camera_path.h"
#include "flights.h"

namespace overfly {
namespace {

using flights::deg;
using flights::keyframe;
using flights::looking;
using flights::path;
using flights::place;

// How fast the camera turns just before and just after a time, as vectors: the difference of the view's rates.
double rate_jump_per_s(const CameraPath& flight, double time_s) {
    constexpr double kStep_s = 1e-4;
    const auto axes_jump = [&](auto axis) {
        const Vector<Scene> before = axis(time_s) - axis(time_s - kStep_s),
                            after = axis(time_s + kStep_s) - axis(time_s);
        return length(after - before) / kStep_s;
    };
    return std::max(axes_jump([&](double t) { return flight.pose_at(t).orientation.z; }),
                    axes_jump([&](double t) { return flight.pose_at(t).orientation.x; }));
}

TEST(AimCurve, KeepsTheTargetInTheMiddleAtEveryTime) {
    const FlightPlace target = place(7.01, 46.01, 800.0);
    const CameraPath flight =
        path({looking(0.0, place(7.0, 46.0, 2000.0), target), looking(10.0, place(7.01, 46.0, 2100.0), target, 10.0),
              looking(15.0, place(7.02, 46.01, 1900.0), target), looking(30.0, place(7.01, 46.02, 1900.0), target)});
    const Point<Scene> at = flight.frame().scene({target.lon, target.lat, target.height_m});
    for (double t = 0.0; t <= 30.0; t += 0.01) {
        const Point<Camera> seen = flight.pose_at(t).camera_from_scene() * at;
        EXPECT_LT(std::hypot(seen.x, seen.y) / seen.z, 1e-11) << t;
    }
}

TEST(AimCurve, ATargetThatMovesDoesSoSmoothly) {
    std::vector<Keyframe> keys;
    for (int i = 0; i < 5; ++i)
        keys.push_back(
            looking(2.0 * i, place(7.0 + 0.002 * i, 46.0, 2000.0), place(7.003 * 1.0 + 0.001 * i * i, 46.01, 500.0)));
    const CameraPath flight = path(keys);
    for (const Keyframe& key : keys) {
        const FlightPlace& target = std::get<LookAt>(key.aim).target;
        const Point<Camera> seen = flight.pose_at(key.time_s).camera_from_scene() *
                                   flight.frame().scene({target.lon, target.lat, target.height_m});
        EXPECT_LT(std::hypot(seen.x, seen.y) / seen.z, 1e-10);
        EXPECT_LT(rate_jump_per_s(flight, key.time_s), 1e-4);
    }
}

TEST(AimCurve, AttitudeAndLookAtJoinWithOneRate) {
    const FlightPlace target = place(7.02, 46.01, 800.0);
    const std::vector<Keyframe> keys{keyframe(0.0, place(7.0, 46.0, 2000.0), {deg(300.0), deg(-10.0), deg(0.0)}),
                                     keyframe(4.0, place(7.005, 46.0, 2000.0), {deg(330.0), deg(-20.0), deg(10.0)}),
                                     looking(9.0, place(7.01, 46.0, 2000.0), target),
                                     looking(14.0, place(7.02, 46.0, 2000.0), target),
                                     keyframe(17.0, place(7.025, 46.0, 2000.0), {deg(90.0), deg(0.0), deg(0.0)}),
                                     looking(22.0, place(7.03, 46.0, 2000.0), target),
                                     keyframe(30.0, place(7.04, 46.0, 2000.0), {deg(90.0), deg(0.0), deg(0.0)})};
    const CameraPath flight = path(keys);
    // Two spans' accelerations over 0.1 ms, not a step in the rate.
    for (std::size_t i = 1; i + 1 < keys.size(); ++i) EXPECT_LT(rate_jump_per_s(flight, keys[i].time_s), 2e-4) << i;
    double largest_step = 0.0;
    for (double t = 0.0; t < 30.0; t += 0.01)
        largest_step =
            std::max(largest_step, length(flight.pose_at(t + 0.01).orientation.z - flight.pose_at(t).orientation.z));
    EXPECT_LT(largest_step, 0.02);
}

TEST(AimCurve, StraightOverTheTargetIsFinite) {
    const FlightPlace target = place(7.0, 46.0, 0.0);
    const CameraPath flight =
        path({looking(0.0, place(7.0, 45.99, 1000.0), target), looking(10.0, place(7.0, 46.0, 1000.0), target),
              looking(20.0, place(7.0, 46.01, 1000.0), target),
              keyframe(25.0, place(7.0, 46.02, 1000.0), {deg(0.0), deg(-20.0), deg(0.0)})});
    const Point<Scene> at = flight.frame().scene({target.lon, target.lat, 0.0});
    for (double t = 0.0; t <= 20.0; t += 0.125) {
        const Point<Camera> seen = flight.pose_at(t).camera_from_scene() * at;
        EXPECT_LT(std::hypot(seen.x, seen.y) / seen.z, 1e-9) << t;
    }
}

TEST(AimCurve, ALookAtThatTurnsTooFastDoesNotSpinTheNextSpan) {
    // The joint is right over the target, where the heading's rate has no bound.
    const FlightPlace target = place(7.0, 46.0, 0.0);
    const CameraPath flight =
        path({looking(0.0, place(7.0, 45.99, 1000.0), target), looking(10.0, place(7.0, 46.0, 1000.0), target),
              keyframe(20.0, place(7.0, 46.02, 1000.0), {deg(0.0), deg(-20.0), deg(0.0)})});
    double turned_rad = 0.0;
    for (double t = 10.0; t < 20.0; t += 0.01)
        turned_rad += length(flight.pose_at(t + 0.01).orientation.x - flight.pose_at(t).orientation.x);
    EXPECT_LT(turned_rad, 2.0 * 2.0 * std::numbers::pi);
}

}  // namespace
}  // namespace overfly
