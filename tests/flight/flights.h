#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "flight/camera_path.h"
#include "flight/keyframe.h"

// Keyframes and surroundings that the flight tests share.
namespace overfly::flights {

inline Angle deg(double d) { return Angle::degrees(d); }

inline FlightPlace place(double lon_deg, double lat_deg, double height_m) {
    return {deg(lon_deg), deg(lat_deg), height_m, HeightAbove::Ellipsoid};
}

inline Keyframe keyframe(double time_s, FlightPlace at, Attitude aim, double fov_deg = 60.0) {
    return {time_s, at, aim, Lens{deg(fov_deg), 36.0}};
}

inline Keyframe looking(double time_s, FlightPlace at, FlightPlace target, double roll_deg = 0.0) {
    return {time_s, at, LookAt{target, deg(roll_deg)}, Lens{}};
}

// The smooth ellipsoid itself is the ground.
inline Surroundings bare_ellipsoid() {
    return {[](Angle, Angle) { return 0.0; }, [](Angle, Angle) { return 0.0; }, [](Point<Scene>) { return 100.0; }};
}

inline SceneFrame frame_at(double lon_deg, double lat_deg) { return SceneFrame({deg(lon_deg), deg(lat_deg), 0.0}); }

inline CameraPath path(const std::vector<Keyframe>& keyframes) {
    const FlightPlace& first = keyframes.front().place;
    return {keyframes, SceneFrame({first.lon, first.lat, 0.0}), bare_ellipsoid()};
}

// The degrees of longitude and latitude that a metre is at the equator, about.
inline constexpr double kDegPerM = 1.0 / 111'319.5;

// A flight that does a little of everything, of uneven keyframes.
inline std::vector<Keyframe> varied() {
    return {keyframe(0.0, place(0.00, 0.00, 500.0), {deg(350.0), deg(-5.0), deg(0.0)}),
            keyframe(2.0, place(0.002, 0.001, 520.0), {deg(10.0), deg(-8.0), deg(5.0)}, 50.0),
            keyframe(3.0, place(0.003, 0.003, 560.0), {deg(40.0), deg(-20.0), deg(20.0)}, 40.0),
            keyframe(5.5, place(0.003, 0.006, 540.0), {deg(20.0), deg(-30.0), deg(0.0)}, 40.0),
            keyframe(6.0, place(0.0025, 0.0065, 500.0), {deg(0.0), deg(-10.0), deg(-15.0)}, 70.0),
            keyframe(9.0, place(-0.001, 0.008, 480.0), {deg(300.0), deg(0.0), deg(0.0)}, 60.0)};
}

}  // namespace overfly::flights
