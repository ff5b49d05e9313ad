#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "flight/keyframe.h"
#include "flight/place_curve.h"
#include "flight/spline.h"
#include "geo/scene_frame.h"

namespace overfly {

// Where the camera looks: the attitude through the keyframes' aims.
//
// Between two attitudes heading, pitch and roll are splines; headings follow each other by the shorter way, roll as it
// is written (0 to 360 is a barrel roll). Between two look-ats the target moves on a PlaceCurve and the camera is
// turned towards it exactly. Between an attitude and a look-at heading and pitch are quintics that leave the one and
// join the other with its rates.
// GUARANTEES: C1 as long as a look-at next to an attitude turns by less than kMostTurns in the time of the span between
// the two (a target flown over closely turns faster; there, C0).
class AimCurve {
  public:
    static constexpr double kMostTurns = 1.0;

    // REQUIRES: `targets` has a place for each keyframe with a LookAt; times strictly increasing.
    AimCurve(std::span<const Keyframe> keyframes, std::span<const std::optional<Geodetic>> targets,
             const PlaceCurve& camera, const SceneFrame& frame);

    // The heading is continuous between two keyframes, but for whole turns between spans.
    [[nodiscard]] Attitude at(double time_s) const;

  private:
    struct HeadingPitch {
        Knot<double> heading, pitch;
    };
    struct MixedSpan {
        HeadingPitch from, to;
    };

    [[nodiscard]] std::vector<double> angles_rad(std::span<const Keyframe> keyframes, Angle Attitude::*angle) const;
    [[nodiscard]] Attitude look_at(const PlaceCurve& target, double time_s) const;
    [[nodiscard]] HeadingPitch attitude_knot(std::size_t keyframe) const;
    [[nodiscard]] HeadingPitch look_at_knot(std::size_t keyframe, std::size_t neighbour) const;

    PlaceCurve camera_;
    SceneFrame frame_;
    std::vector<double> times_s_;
    std::vector<std::optional<std::size_t>> target_of_;  // which of targets_ a keyframe looks at
    std::vector<PlaceCurve> targets_;                    // one for each run of neighbouring look-ats
    // In radians. In heading and pitch a look-at counts with the attitude that it has at its own time.
    Spline<double> heading_, pitch_, roll_;
    std::vector<std::optional<MixedSpan>> mixed_;  // by the keyframe that begins the span
};

}  // namespace overfly
