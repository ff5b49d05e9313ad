#pragma once

#include <array>

#include "core/time_range.h"

namespace overfly {

// How far a shutter is open while an exposure lasts: all of it (box), or it opens at an even pace and closes so
// (trapezoid), or it starts and ends those two movements gently (smooth: 3 s^2 - 2 s^3).
struct ShutterCurve {
    enum class Shape { Box, Trapezoid, Smooth };
    Shape shape = Shape::Box;
    double ramp = 0.25;  // part of the exposure that it takes to open, and to close: above 0, up to 1/2. Not of a box

    [[nodiscard]] bool is_box() const { return shape == Shape::Box; }

    // The part of an exposure's light that has come through when a part s of its time has gone, 0 to 1 for 0 to 1.
    // Exact but for rounding.
    [[nodiscard]] double share_until(double s) const;
    // Its inverse, to 1e-12.
    [[nodiscard]] double part_until(double share) const;
    // Its derivative: 1 for a box, and 1 on average for all.
    [[nodiscard]] double openness(double s) const;
    // Where share_until changes from one polynomial to another.
    [[nodiscard]] std::array<double, 2> joints() const { return {ramp, 1.0 - ramp}; }

    friend constexpr bool operator==(const ShutterCurve&, const ShutterCurve&) = default;
};

// One exposure: when it is, and what each stretch of it counts for. What a line sees for a while has the weight of that
// stretch, whoever integrates it. REQUIRES, of all but the members: it lasts for some time.
struct Exposure {
    TimeRange when;
    ShutterCurve curve{};

    // Of a part of it; the shares of parts that make up the whole add up to 1.
    [[nodiscard]] double share_of(TimeRange part) const {
        if (curve.is_box()) return part.duration_s() / when.duration_s();
        return share_until(part.end_s) - share_until(part.begin_s);
    }
    [[nodiscard]] double part_at(double time_s) const { return (time_s - when.begin_s) / when.duration_s(); }
    [[nodiscard]] double share_until(double time_s) const { return curve.share_until(part_at(time_s)); }
    // When so much of the light has come through.
    [[nodiscard]] double time_at(double share) const {
        return when.begin_s + when.duration_s() * curve.part_until(share);
    }
};

}  // namespace overfly
