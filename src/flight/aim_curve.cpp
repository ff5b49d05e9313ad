#include "flight/aim_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "flight/attitude.h"
#include "flight/derivative.h"

namespace overfly {
namespace {

using Targets = std::span<const std::optional<Geodetic>>;

bool is_look_at(const Keyframe& keyframe) { return std::holds_alternative<LookAt>(keyframe.aim); }

std::vector<double> times_of(std::span<const Keyframe> keyframes) {
    std::vector<double> times_s;
    for (const Keyframe& keyframe : keyframes) times_s.push_back(keyframe.time_s);
    return times_s;
}

std::vector<double> rolls_rad(std::span<const Keyframe> keyframes) {
    std::vector<double> result;
    for (const Keyframe& keyframe : keyframes)
        result.push_back(std::visit([](const auto& aim) { return aim.roll.radians(); }, keyframe.aim));
    return result;
}

// Neighbouring look-ats get the same number, counted from 0.
std::vector<std::optional<std::size_t>> number_runs(std::span<const Keyframe> keyframes) {
    std::vector<std::optional<std::size_t>> result;
    std::size_t runs = 0;
    for (const Keyframe& keyframe : keyframes) {
        if (!is_look_at(keyframe)) {
            result.emplace_back();
            continue;
        }
        if (result.empty() || !result.back()) ++runs;
        result.emplace_back(runs - 1);
    }
    return result;
}

std::vector<PlaceCurve> target_curves(std::span<const Keyframe> keyframes, Targets targets) {
    std::vector<PlaceCurve> result;
    std::vector<double> times_s;
    std::vector<Geodetic> places;
    for (std::size_t i = 0; i < keyframes.size(); ++i) {
        if (!is_look_at(keyframes[i])) continue;
        times_s.push_back(keyframes[i].time_s);
        places.push_back(targets[i].value());
        if (i + 1 < keyframes.size() && is_look_at(keyframes[i + 1])) continue;
        result.emplace_back(times_s, places);
        times_s.clear();
        places.clear();
    }
    return result;
}

// A knot whose rates carry it no further than kMostTurns in `span_s`.
Knot<double> limited(Knot<double> knot, double span_s) {
    const double most_rad = AimCurve::kMostTurns * 2.0 * std::numbers::pi;
    knot.velocity = std::clamp(knot.velocity, -most_rad / span_s, most_rad / span_s);
    const double most_acceleration = 2.0 * most_rad / (span_s * span_s);
    knot.acceleration = std::clamp(knot.acceleration, -most_acceleration, most_acceleration);
    return knot;
}

}  // namespace

AimCurve::AimCurve(std::span<const Keyframe> keyframes, Targets targets, const PlaceCurve& camera,
                   const SceneFrame& frame)
    : camera_(camera),
      frame_(frame),
      times_s_(times_of(keyframes)),
      target_of_(number_runs(keyframes)),
      targets_(target_curves(keyframes, targets)),
      heading_(times_s_, angles_rad(keyframes, &Attitude::heading)),
      pitch_(times_s_, angles_rad(keyframes, &Attitude::pitch)),
      roll_(times_s_, rolls_rad(keyframes)),
      mixed_(keyframes.size()) {
    for (std::size_t i = 0; i + 1 < keyframes.size(); ++i) {
        if (is_look_at(keyframes[i]) == is_look_at(keyframes[i + 1])) continue;
        mixed_[i] = is_look_at(keyframes[i]) ? MixedSpan{look_at_knot(i, i + 1), attitude_knot(i + 1)}
                                             : MixedSpan{attitude_knot(i), look_at_knot(i + 1, i)};
    }
}

Attitude AimCurve::at(double time_s) const {
    const auto after = std::upper_bound(times_s_.begin() + 1, times_s_.end() - (times_s_.size() > 1 ? 1 : 0), time_s);
    const std::size_t span = static_cast<std::size_t>(after - times_s_.begin()) - 1;
    Attitude attitude;
    if (mixed_[span]) {
        const auto& [from, to] = *mixed_[span];
        attitude.heading = Angle::radians(quintic_at(from.heading, to.heading, time_s));
        attitude.pitch = Angle::radians(quintic_at(from.pitch, to.pitch, time_s));
    } else if (target_of_[span]) {
        attitude = look_at(targets_[*target_of_[span]], time_s);
    } else {
        attitude.heading = Angle::radians(heading_.at(time_s));
        attitude.pitch = Angle::radians(pitch_.at(time_s));
    }
    attitude.roll = Angle::radians(roll_.at(time_s));
    return attitude;
}

Attitude AimCurve::look_at(const PlaceCurve& target, double time_s) const {
    const Geodetic place = camera_.at(time_s);
    return attitude_towards(frame_.scene(target.at(time_s)) - frame_.scene(place), frame_.local_axes(place));
}

// Heading or pitch at the keyframes, headings without jumps.
std::vector<double> AimCurve::angles_rad(std::span<const Keyframe> keyframes, Angle Attitude::*angle) const {
    std::vector<double> result;
    for (std::size_t i = 0; i < keyframes.size(); ++i) {
        const auto* given = std::get_if<Attitude>(&keyframes[i].aim);
        Angle next = (given ? *given : look_at(targets_[target_of_[i].value()], times_s_[i])).*angle;
        if (angle == &Attitude::heading && i > 0) next = nearest_turn(next, Angle::radians(result.back()));
        result.push_back(next.radians());
    }
    return result;
}

AimCurve::HeadingPitch AimCurve::attitude_knot(std::size_t keyframe) const {
    return {heading_.knots()[keyframe], pitch_.knots()[keyframe]};
}

// The look-at's own rates, on the turn that the spline of headings has chosen. The camera and the target go on smoothly
// beyond their joints, so differences may reach across.
AimCurve::HeadingPitch AimCurve::look_at_knot(std::size_t keyframe, std::size_t neighbour) const {
    const double time_s = times_s_[keyframe], span_s = std::abs(times_s_[neighbour] - time_s);
    constexpr double kStep = 1e-3;  // of the span: far above rounding (1e-9 m), far below what a camera does in a span
    const PlaceCurve& target = targets_[target_of_[keyframe].value()];
    const Angle heading = Angle::radians(heading_.knots()[keyframe].value);
    const auto rates = [&](auto angle_rad) { return derivatives_at(angle_rad, time_s, kStep * span_s); };
    const auto h = rates([&](double t) { return nearest_turn(look_at(target, t).heading, heading).radians(); });
    const auto p = rates([&](double t) { return look_at(target, t).pitch.radians(); });
    return {limited({time_s, h.value, h.velocity, h.acceleration}, span_s),
            limited({time_s, p.value, p.velocity, p.acceleration}, span_s)};
}

}  // namespace overfly
