#pragma once

#include <optional>

#include "flight/shutter.h"

namespace overfly {

// A frame's label in SMPTE 12M time code. The frame field ends at 29: above 30 frames per second it counts pairs of
// frames, and the field flag tells the second of a pair.
struct SmpteTime {
    int hours = 0, minutes = 0, seconds = 0, frame = 0;
    bool second_of_pair = false;

    friend constexpr bool operator==(const SmpteTime&, const SmpteTime&) = default;
};

// The label of frame `number`, counted without drop frames from frame 0 = 00:00:00:00 and wrapped after 24 hours.
// Rates of n/1 and n * 1000/1001 frames per second up to 60 have time code; others have none.
[[nodiscard]] std::optional<SmpteTime> smpte_time(int number, FrameRate rate);

}  // namespace overfly
