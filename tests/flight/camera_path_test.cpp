#include "flight/camera_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flight/derivative.h"
#include "flights.h"

namespace overfly {
namespace {

using flights::deg;
using flights::kDegPerM;
using flights::keyframe;
using flights::looking;
using flights::path;
using flights::place;

Geodetic geodetic_of(const FlightPlace& p) { return {p.lon, p.lat, p.height_m}; }

double off_m(const CameraPath& flight, const Keyframe& key) {
    return distance(flight.pose_at(key.time_s).position, flight.frame().scene(geodetic_of(key.place)));
}

TEST(CameraPath, PassesThroughItsKeyframes) {
    const std::vector<Keyframe> keys = flights::varied();
    const CameraPath flight = path(keys);
    for (const Keyframe& key : keys) {
        EXPECT_LT(off_m(flight, key), 1e-6);
        const Attitude& aim = std::get<Attitude>(key.aim);
        const Attitude at = flight.attitude_at(key.time_s);
        EXPECT_NEAR(std::remainder(at.heading.degrees() - aim.heading.degrees(), 360.0), 0.0, 1e-9);
        EXPECT_NEAR(at.pitch.degrees(), aim.pitch.degrees(), 1e-9);
        EXPECT_NEAR(at.roll.degrees(), aim.roll.degrees(), 1e-9);
        EXPECT_NEAR(flight.pose_at(key.time_s).tan_half_fov, key.lens.tan_half_fov(), 1e-12);
    }
    EXPECT_EQ(flight.times(), (TimeRange{0.0, 9.0}));
    EXPECT_EQ(flight.joints_s().size(), keys.size());
}

// What a derivative jumps by at a joint: the difference between its two sides, extrapolated to no distance by the
// parabola through three distances. derivative(t) must look less than 2 ms around it.
template <class Derivative>
double jump_at(double joint_s, Derivative derivative) {
    const auto difference = [&](double aside_s) {
        return derivative(joint_s + aside_s) - derivative(joint_s - aside_s);
    };
    return length(8.0 * difference(2e-3) - 6.0 * difference(4e-3) + difference(8e-3)) / 3.0;
}

TEST(CameraPath, PositionIsC2AndOrientationC1AtKeyframes) {
    const std::vector<Keyframe> keys = flights::varied();
    const CameraPath flight = path(keys);
    constexpr double kStep_s = 5e-4;
    const auto position = [&](double t) {
        return derivatives_at([&](double at) { return flight.pose_at(at).position - Point<Scene>{}; }, t, kStep_s);
    };
    const auto right = [&](double t) {
        return derivatives_at([&](double at) { return flight.pose_at(at).orientation.x; }, t, kStep_s);
    };
    for (std::size_t i = 1; i + 1 < keys.size(); ++i) {
        const double joint_s = keys[i].time_s;
        EXPECT_LT(jump_at(joint_s, [&](double t) { return position(t).velocity; }), 5e-3);     // of 100 m/s
        EXPECT_LT(jump_at(joint_s, [&](double t) { return position(t).acceleration; }), 0.5);  // of 200 m/s^2
        EXPECT_LT(jump_at(joint_s, [&](double t) { return right(t).velocity; }), 1e-4);
    }
}

TEST(CameraPath, LevelFlightStaysLevelOver100Km) {
    std::vector<Keyframe> keys;
    for (int i = 0; i <= 2; ++i) keys.push_back(keyframe(500.0 * i, place(7.0 + 0.6 * i, 46.0 + 0.2 * i, 3000.0), {}));
    const CameraPath flight = path(keys);
    const double span_m = geodesic_length_m(flight.place_at(0.0), flight.place_at(1000.0));
    EXPECT_GT(span_m, 100'000.0);
    for (double t = 0.0; t <= 1000.0; t += 3.7)
        EXPECT_NEAR(flight.frame().geodetic(flight.pose_at(t).position).height_m, 3000.0, 1e-4);
}

TEST(CameraPath, CruisesAtASteadySpeedBetweenTwoKeyframes) {
    const CameraPath flight =
        path({keyframe(0.0, place(10.0, 50.0, 1000.0), {}), keyframe(100.0, place(10.1, 50.0, 1000.0), {})});
    const auto speed = [&](double t) { return distance(flight.pose_at(t).position, flight.pose_at(t + 1.0).position); };
    EXPECT_NEAR(speed(0.0) / speed(50.0), 1.0, 1e-5);
    // And goes on so outside its own times.
    EXPECT_NEAR(speed(-2.0) / speed(0.0), 1.0, 1e-5);
    EXPECT_NEAR(speed(100.0) / speed(99.0), 1.0, 1e-5);
}

TEST(CameraPath, HoverStandsStill) {
    const std::vector<Keyframe> keys{keyframe(0.0, place(0.0, 0.0, 100.0), {}),
                                     keyframe(2.0, place(0.01, 0.01, 200.0), {}),
                                     keyframe(5.0, place(0.01, 0.01, 200.0), {deg(90.0), deg(0.0), deg(0.0)}),
                                     keyframe(7.0, place(0.03, 0.01, 100.0), {})};
    const CameraPath flight = path(keys);
    for (double t = 2.0; t <= 5.0; t += 0.05) EXPECT_EQ(flight.pose_at(t).position, flight.pose_at(2.0).position);
}

TEST(CameraPath, OneKeyframeStandsForEver) {
    const CameraPath flight = path({keyframe(3.0, place(179.99, -89.0, 100.0), {deg(20.0), deg(-90.0), deg(5.0)})});
    for (const double t : {-10.0, 3.0, 50.0}) {
        EXPECT_LT(distance(flight.pose_at(t).position, flight.pose_at(3.0).position), 1e-6);
        EXPECT_NEAR(flight.attitude_at(t).heading.degrees(), 20.0, 1e-9);
        EXPECT_EQ(flight.attitude_at(t).roll, deg(5.0));
    }
}

TEST(CameraPath, CrossesTheAntimeridianTheShortWay) {
    const CameraPath flight =
        path({keyframe(0.0, place(179.9, 10.0, 100.0), {}), keyframe(10.0, place(-179.9, 10.0, 100.0), {}),
              keyframe(20.0, place(180.3, 10.0, 100.0), {})});
    for (double t = 0.0; t < 20.0; t += 0.1) {
        EXPECT_GT(std::abs(flight.place_at(t).lon.degrees()), 179.6);
        EXPECT_LT(distance(flight.pose_at(t).position, flight.pose_at(t + 0.1).position), 400.0);
    }
}

TEST(CameraPath, FliesOverThePole) {
    const FlightPlace target = place(50.0, 89.95, 0.0);
    const CameraPath flight =
        path({looking(0.0, place(0.0, 89.9, 3000.0), target), looking(10.0, place(0.0, 90.0, 3000.0), target),
              looking(20.0, place(180.0, 89.9, 3000.0), target)});
    for (double t = 0.0; t < 20.0; t += 0.05) {
        EXPECT_NEAR(flight.place_at(t).height_m, 3000.0, 1e-6);
        EXPECT_LT(distance(flight.pose_at(t).position, flight.pose_at(t + 0.05).position), 100.0);
        EXPECT_LT(length(flight.pose_at(t).orientation.z - flight.pose_at(t + 0.05).orientation.z), 0.03);
    }
    EXPECT_NEAR(flight.place_at(10.0).lat.degrees(), 90.0, 1e-9);
}

TEST(CameraPath, HeadingTakesTheShorterWayAndRollTheWrittenOne) {
    const CameraPath flight = path({keyframe(0.0, place(0.0, 0.0, 100.0), {deg(350.0), deg(0.0), deg(0.0)}),
                                    keyframe(1.0, place(0.0, 0.001, 100.0), {deg(10.0), deg(0.0), deg(360.0)})});
    EXPECT_NEAR(std::remainder(flight.attitude_at(0.5).heading.degrees(), 360.0), 0.0, 1e-9);
    EXPECT_NEAR(flight.attitude_at(0.5).roll.degrees(), 180.0, 1e-9);
}

TEST(CameraPath, AnglesAndLensStayBetweenTheirKeyframes) {
    const std::vector<Keyframe> keys = flights::varied();
    const CameraPath flight = path(keys);
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const auto expect_between = [](double value, double a, double b) {
            EXPECT_GE(value, std::min(a, b) - 1e-9);
            EXPECT_LE(value, std::max(a, b) + 1e-9);
        };
        const auto &from = std::get<Attitude>(keys[i].aim), &to = std::get<Attitude>(keys[i + 1].aim);
        for (double t = keys[i].time_s; t <= keys[i + 1].time_s; t += 0.01) {
            expect_between(flight.place_at(t).height_m, keys[i].place.height_m, keys[i + 1].place.height_m);
            expect_between(flight.attitude_at(t).pitch.degrees(), from.pitch.degrees(), to.pitch.degrees());
            expect_between(flight.attitude_at(t).roll.degrees(), from.roll.degrees(), to.roll.degrees());
            expect_between(flight.pose_at(t).tan_half_fov, keys[i].lens.tan_half_fov(),
                           keys[i + 1].lens.tan_half_fov());
        }
    }
}

TEST(CameraPath, MovingAKeyframeChangesNearSpansOnly) {
    std::vector<Keyframe> keys;
    for (int i = 0; i < 12; ++i)
        keys.push_back(keyframe(i, place(0.001 * i, 0.002 * std::sin(i), 100.0 + 10.0 * std::cos(2.0 * i)), {}));
    const CameraPath before = path(keys);
    keys[6].place = place(0.007, 0.01, 300.0);
    const CameraPath after = path(keys);
    for (double t = 0.0; t <= 11.0; t += 0.05)
        if (t < 3.0 || t > 9.0) {
            EXPECT_EQ(before.pose_at(t).position, after.pose_at(t).position) << t;
        }
    EXPECT_NE(before.pose_at(5.5).position, after.pose_at(5.5).position);
}

TEST(CameraPath, GoesOnStraightTurningAndZoomingOutsideItsTimes) {
    const CameraPath flight = path(flights::varied());
    const auto position = [&](double t) { return flight.pose_at(t).position; };
    for (const double end_s : {0.0, 9.0}) {
        const double out = end_s == 0.0 ? -1.0 : 1.0, step_s = 1e-3;
        // One-sided, of second order.
        const Vector<Scene> inside = (3.0 * (position(end_s) - position(end_s - out * step_s)) -
                                      (position(end_s - out * step_s) - position(end_s - 2.0 * out * step_s))) /
                                     (2.0 * step_s);
        const Vector<Scene> outside = (position(end_s + out * step_s) - position(end_s)) / step_s;
        EXPECT_LT(length(inside - outside), 1e-3);
        const Vector<Scene> farther = (position(end_s + out * 2.0) - position(end_s)) / 2.0;
        EXPECT_LT(length(farther - outside), 1e-4);
        const double in_deg =
            flight.attitude_at(end_s).heading.degrees() - flight.attitude_at(end_s - out * 1e-3).heading.degrees();
        const double out_deg =
            flight.attitude_at(end_s + out * 1e-3).heading.degrees() - flight.attitude_at(end_s).heading.degrees();
        EXPECT_NEAR(std::remainder(in_deg - out_deg, 360.0), 0.0, 1e-4);
        const auto log_lens = [&](double s) { return std::log(flight.pose_at(end_s + out * s).tan_half_fov); };
        EXPECT_NEAR((log_lens(1e-3) - log_lens(0.0)) / 1e-3, (log_lens(0.0) - log_lens(-1e-3)) / 1e-3, 1e-3);
        EXPECT_NEAR((log_lens(1.0) - log_lens(0.0)), (log_lens(1e-3) - log_lens(0.0)) / 1e-3, 1e-6);
    }
}

TEST(CameraPath, CountsHeightsFromGroundAndSea) {
    Surroundings world = flights::bare_ellipsoid();
    world.ground_height_m = [](Angle, Angle) { return 1200.0; };
    world.sea_level_m = [](Angle, Angle) { return 45.0; };
    Keyframe above_ground = keyframe(0.0, place(1.0, 2.0, 10.0), {});
    above_ground.place.above = HeightAbove::Ground;
    Keyframe above_sea = keyframe(1.0, place(1.0, 2.001, 2000.0), {});
    above_sea.place.above = HeightAbove::SeaLevel;
    const CameraPath flight({above_ground, above_sea}, flights::frame_at(1.0, 2.0), world);
    EXPECT_NEAR(flight.place_at(0.0).height_m, 1210.0, 1e-9);
    EXPECT_NEAR(flight.place_at(1.0).height_m, 2045.0, 1e-9);
}

TEST(CameraPath, CameraFromSceneInvertsThePose) {
    const CameraPose pose = path(flights::varied()).pose_at(4.0);
    const Point<Scene> ahead = pose.position + 10.0 * pose.orientation.z + 2.0 * pose.orientation.x;
    EXPECT_LT(distance(pose.camera_from_scene() * ahead, Point<Camera>{2, 0, 10}), 1e-9);
}

}  // namespace
}  // namespace overfly
