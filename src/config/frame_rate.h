#pragma once

#include <optional>
#include <string_view>

#include "flight/shutter.h"

namespace overfly::config {

// What parse_frame_rate takes, for messages.
inline constexpr std::string_view kFrameRateAllowed =
    "frames per second, above 0, up to 1000, with at most three decimals, or a ratio as 24000/1001";

// A rate as a ratio in its lowest terms: "25", "12.5", "24000/1001". A decimal that is within half a thousandth of an
// NTSC rate means it: 23.976 is 24000/1001, 29.97 is 30000/1001.
[[nodiscard]] std::optional<FrameRate> parse_frame_rate(std::string_view text);

}  // namespace overfly::config
