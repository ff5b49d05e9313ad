#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

namespace overfly {

// A moment, and the clock of a place to tell it by.
struct LocalTime {
    std::chrono::sys_time<std::chrono::microseconds> utc;
    std::chrono::minutes ahead_of_utc{0};  // of the clock: -6 h in Colorado's summer

    // What the clock shows, as if that were UTC.
    [[nodiscard]] std::chrono::sys_time<std::chrono::microseconds> clock() const { return utc + ahead_of_utc; }

    friend constexpr bool operator==(const LocalTime&, const LocalTime&) = default;
};

// To the nearest microsecond, by the same clock.
[[nodiscard]] LocalTime later(LocalTime time, double by_s);

// What parse_local_time takes, for messages.
inline constexpr std::string_view kLocalTimeAllowed =
    "a date and local time with its distance from UTC, as 2026-06-21T09:30:00-06:00";

// ISO 8601, years 1 to 9999: "2026-06-21T09:30:00-06:00", with up to six decimals of a second; "Z" is "+00:00". A blank
// may stand for the T, as YAML writes times.
[[nodiscard]] std::optional<LocalTime> parse_local_time(std::string_view text);

// "2026-06-21T09:30:00-06:00", with six decimals of a second where it isn't a whole one.
[[nodiscard]] std::string iso_text(const LocalTime& time);

}  // namespace overfly
