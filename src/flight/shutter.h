#pragma once

#include <cstdint>
#include <optional>

#include "core/angle.h"
#include "core/time_range.h"
#include "flight/exposure.h"

namespace overfly {

// Frames per second as a ratio of integers: 24/1, 24000/1001. Both positive.
struct FrameRate {
    std::int32_t numerator = 24, denominator = 1;

    [[nodiscard]] double per_s() const { return static_cast<double>(numerator) / denominator; }
    // Time of the k-th frame after time 0, without accumulated rounding.
    [[nodiscard]] double time_s(std::int64_t k) const {
        return static_cast<double>(k * denominator) / static_cast<double>(numerator);
    }
    friend constexpr bool operator==(FrameRate, FrameRate) = default;
};

// A shutter is open for angle/360 of a frame, or for so many seconds of the flight, opening and closing included. Where
// the frame's own time lies in the exposure is the phase: it opens on the frame, is centred on it (the default, as in
// Blender), or closes on it.
struct Shutter {
    enum class Phase { Start, Centre, End };
    Angle angle = Angle::degrees(180.0);  // [0, 360] degrees; 0 is an instant
    Phase phase = Phase::Centre;
    std::optional<double> seconds{};  // instead of the angle
    ShutterCurve curve{};

    // How much of an exposure is before the frame's own time.
    [[nodiscard]] double part_before() const {
        return phase == Phase::Start ? 0.0 : phase == Phase::Centre ? 0.5 : 1.0;
    }
    [[nodiscard]] double exposure_s(FrameRate rate) const {
        return seconds.value_or(angle.degrees() / 360.0 / rate.per_s());
    }
    [[nodiscard]] TimeRange open(double frame_time_s, FrameRate rate) const {
        const double exposure = exposure_s(rate);
        const double before = part_before() * exposure;
        return {frame_time_s - before, frame_time_s - before + exposure};
    }
    friend constexpr bool operator==(const Shutter&, const Shutter&) = default;
};

}  // namespace overfly
