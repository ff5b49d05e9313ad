#include "flight/camera_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/error.h"
#include "flight/aim_curve.h"
#include "flight/attitude.h"
#include "flight/derivative.h"
#include "flight/place_curve.h"
#include "flight/resolve_place.h"

namespace overfly {
namespace {

// The camera at one time, before its angles become axes.
struct State {
    Geodetic place;
    Attitude attitude;
    double log_tan_half_fov = 0.0;  // in which zooming at a steady rate looks steady
};

// Heading, pitch and roll in radians, as the three numbers of a vector.
struct Angles;

// How the flight goes on beyond one of its ends.
struct Departure {
    double time_s = 0.0;
    State state;
    Point<Scene> position;
    Vector<Scene> velocity_m_per_s;
    Vector<Angles> turning_per_s;
    double zoom_per_s = 0.0;
};

std::vector<double> times_of(const std::vector<Keyframe>& keyframes) {
    check(!keyframes.empty(), "a flight has a keyframe");
    std::vector<double> times_s;
    for (const Keyframe& keyframe : keyframes) times_s.push_back(keyframe.time_s);
    return times_s;
}

Geodetic resolved(const FlightPlace& place, const Surroundings& surroundings) {
    const std::optional<Geodetic> result = resolve_place(place, surroundings);
    check(result.has_value(), "a flight's heights are counted from ground that is there");
    return *result;
}

std::vector<Geodetic> places_of(const std::vector<Keyframe>& keyframes, const Surroundings& surroundings) {
    std::vector<Geodetic> places;
    for (const Keyframe& keyframe : keyframes) places.push_back(resolved(keyframe.place, surroundings));
    return places;
}

std::vector<std::optional<Geodetic>> targets_of(const std::vector<Keyframe>& keyframes,
                                                const Surroundings& surroundings) {
    std::vector<std::optional<Geodetic>> targets;
    for (const Keyframe& keyframe : keyframes) {
        const auto* look_at = std::get_if<LookAt>(&keyframe.aim);
        targets.push_back(look_at ? std::optional(resolved(look_at->target, surroundings)) : std::nullopt);
    }
    return targets;
}

std::vector<double> log_tan_half_fovs(const std::vector<Keyframe>& keyframes) {
    std::vector<double> result;
    for (const Keyframe& keyframe : keyframes) result.push_back(std::log(keyframe.lens.tan_half_fov()));
    return result;
}

}  // namespace

struct CameraPath::Data {
    Data(const std::vector<Keyframe>& keyframes, const SceneFrame& scene_frame, const Surroundings& surroundings)
        : frame(scene_frame),
          times_s(times_of(keyframes)),
          place(times_s, places_of(keyframes, surroundings)),
          aim(keyframes, targets_of(keyframes, surroundings), place, frame),
          log_tan_half_fov(times_s, log_tan_half_fovs(keyframes)),
          before(departure(0)),
          after(departure(times_s.size() - 1)) {}

    // The flight's curves, which go on beyond its ends as polynomials for a little while.
    [[nodiscard]] State curve_at(double time_s) const {
        return {place.at(time_s), aim.at(time_s), log_tan_half_fov.at(time_s)};
    }

    [[nodiscard]] State at(double time_s) const {
        const bool is_before = time_s < times_s.front();
        if (!is_before && time_s <= times_s.back()) return curve_at(time_s);
        const Departure& from = is_before ? before : after;
        const double dt_s = time_s - from.time_s;
        const Vector<Angles> turn = dt_s * from.turning_per_s;
        const Attitude& attitude = from.state.attitude;
        return {frame.geodetic(from.position + dt_s * from.velocity_m_per_s),
                {attitude.heading + Angle::radians(turn.x), attitude.pitch + Angle::radians(turn.y),
                 attitude.roll + Angle::radians(turn.z)},
                from.state.log_tan_half_fov + dt_s * from.zoom_per_s};
    }

    [[nodiscard]] Departure departure(std::size_t end) const {
        const double time_s = times_s[end];
        const State state = curve_at(time_s);
        Departure result{time_s, state, frame.scene(state.place), {}, {}, 0.0};
        if (times_s.size() == 1) return result;
        const double span_s = end == 0 ? times_s[1] - times_s[0] : times_s[end] - times_s[end - 1];
        const double step_s = 1e-3 * span_s;  // as in AimCurve::look_at_knot
        const auto angles = [&](double t) {
            const Attitude a = aim.at(t);
            return Vector<Angles>{nearest_turn(a.heading, state.attitude.heading).radians(), a.pitch.radians(),
                                  a.roll.radians()};
        };
        const auto travelled = [&](double t) { return frame.scene(place.at(t)) - result.position; };
        const auto zoom = [&](double t) { return log_tan_half_fov.at(t); };
        result.velocity_m_per_s = derivatives_at(travelled, time_s, step_s).velocity;
        result.turning_per_s = derivatives_at(angles, time_s, step_s).velocity;
        result.zoom_per_s = derivatives_at(zoom, time_s, step_s).velocity;
        return result;
    }

    SceneFrame frame;
    std::vector<double> times_s;
    PlaceCurve place;
    AimCurve aim;
    Spline<double> log_tan_half_fov;
    Departure before, after;
};

Transform<Camera, Scene> CameraPose::camera_from_scene() const {
    return inverse(Transform<Scene, Camera>{orientation, {position.x, position.y, position.z}});
}

CameraPath::CameraPath(const std::vector<Keyframe>& keyframes, const SceneFrame& frame,
                       const Surroundings& surroundings)
    : data_(std::make_shared<const Data>(keyframes, frame, surroundings)) {}

TimeRange CameraPath::times() const { return {data_->times_s.front(), data_->times_s.back()}; }

CameraPose CameraPath::pose_at(double time_s) const {
    const State state = data_->at(time_s);
    const CameraPose pose{data_->frame.scene(state.place),
                          overfly::orientation(state.attitude, data_->frame.local_axes(state.place)),
                          std::exp(state.log_tan_half_fov)};
    const Vector<Scene> all = pose.orientation.x + pose.orientation.y + pose.orientation.z;
    check(std::isfinite(dot(all, pose.position - Point<Scene>{}) + pose.tan_half_fov), "a camera pose is finite");
    return pose;
}

Geodetic CameraPath::place_at(double time_s) const { return data_->at(time_s).place; }

Attitude CameraPath::attitude_at(double time_s) const {
    Attitude attitude = data_->at(time_s).attitude;
    attitude.heading = nearest_turn(attitude.heading, Angle::degrees(180.0));
    return attitude;
}

const SceneFrame& CameraPath::frame() const { return data_->frame; }

const std::vector<double>& CameraPath::joints_s() const { return data_->times_s; }

}  // namespace overfly
