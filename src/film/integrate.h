#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/time_range.h"
#include "flight/exposure.h"

namespace overfly {

// Calls with_stretch(segment, TimeRange) for every stretch of `open` in which one of the segments is seen, and with
// nullptr for what lies between them; in time order. Segments as below; `open` may have no duration.
template <class Segment, class WithStretch>
void for_each_stretch(std::span<const Segment> segments, TimeRange open, const WithStretch& with_stretch) {
    const Segment* const none = nullptr;
    double reached_s = open.begin_s;
    for (const Segment& s : segments) {
        const TimeRange seen = intersection(s.when, open);
        if (seen.duration_s() <= 0.0) continue;
        if (seen.begin_s > reached_s) with_stretch(none, TimeRange{reached_s, seen.begin_s});
        with_stretch(&s, seen);
        reached_s = seen.end_s;
    }
    if (open.end_s > reached_s) with_stretch(none, TimeRange{reached_s, open.end_s});
}

// Integrates what one image sample sees over one exposure (design 3.5): every stretch of time has the weight that
// the exposure gives it, so visibility and coverage are exact in time.
//
// `segments` have a TimeRange `when`, are in time order and do not overlap; between them the sky is seen. `window` is
// the time that the segments speak of. Calls with_stretch(segment or nullptr, TimeRange, share) with shares of the
// whole exposure that add up to the part of it inside the window. An exposure of no duration counts wholly if the
// window, end excluded, has it: for that one, at_instant(segment or nullptr, time_s) is called.
template <class Segment, class WithStretch, class AtInstant>
void integrate(std::span<const Segment> segments, TimeRange window, const Exposure& exposure,
               const WithStretch& with_stretch, const AtInstant& at_instant) {
    const Segment* const none = nullptr;
    if (exposure.when.duration_s() == 0.0) {
        const double t = exposure.when.begin_s;
        if (t < window.begin_s || t >= window.end_s) return;
        for (const Segment& s : segments) {
            if (s.when.contains(t)) return at_instant(&s, t);
        }
        return at_instant(none, t);
    }
    const TimeRange open = intersection(window, exposure.when);
    if (open.duration_s() <= 0.0) return;
    for_each_stretch(segments, open, [&](const Segment* segment, TimeRange stretch) {
        with_stretch(segment, stretch, exposure.share_of(stretch));
    });
}

namespace detail {

struct GaussRule {
    std::size_t points;
    std::array<double, 3> place;   // from -1 to 1
    std::array<double, 3> weight;  // adding up to 1
};
inline constexpr std::array<GaussRule, 3> kGaussRules = {{
    {1, {0.0}, {1.0}},
    {2, {-0.57735026918962576, 0.57735026918962576}, {0.5, 0.5}},
    {3, {-0.77459666924148338, 0.0, 0.77459666924148338}, {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0}},
}};
// Shares of the exposure from which a stretch gets two and three points. They matter where a triangle is seen for most
// of an exposure, in slow shots and near the ground; a fast flight crosses triangles so quickly that one point a
// stretch is as good (banded ground, a dive, 16 lines: RMSE .00200 with one point throughout, .00200 with three).
inline constexpr double kTwoPointShare = 0.5;
inline constexpr double kThreePointShare = 0.9;

}  // namespace detail

// Where within a stretch of an exposure radiance is smooth, and nothing more is known of it, looks at a few times find
// its mean: those of a Gauss rule of as many points as the stretch is long for. Calls look(time_s, share) with shares
// that add up to the stretch's own.
template <class LookAt>
void for_each_look(TimeRange stretch, double share, const LookAt& look) {
    const detail::GaussRule& rule = detail::kGaussRules[share < detail::kTwoPointShare     ? 0
                                                        : share < detail::kThreePointShare ? 1
                                                                                           : 2];
    for (std::size_t i = 0; i < rule.points; ++i)
        look(stretch.centre_s() + 0.5 * stretch.duration_s() * rule.place[i], share * rule.weight[i]);
}

// The same for light that the exposure weighs: the rule's places are parts of the light that comes through.
template <class LookAt>
void for_each_look(const Exposure& exposure, TimeRange stretch, double share, const LookAt& look) {
    if (exposure.curve.is_box()) return for_each_look(stretch, share, look);
    const TimeRange light = {exposure.share_until(stretch.begin_s), exposure.share_until(stretch.end_s)};
    for_each_look(light, share, [&](double until, double part) { look(exposure.time_at(until), part); });
}

// The same for a tracer that saw instants only: each stands for the whole exposure that it lies in. Exposures are in
// time order and do not overlap.
template <class Segment, class Deposit>
void integrate_instants(std::span<const Segment> instants, std::span<const TimeRange> exposures,
                        const Deposit& deposit) {
    std::size_t e = 0;
    for (const Segment& s : instants) {
        while (e + 1 < exposures.size() && s.when.begin_s >= exposures[e + 1].begin_s) ++e;
        deposit(s, e, s.when.begin_s);
    }
}

}  // namespace overfly
