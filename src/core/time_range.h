#pragma once

#include <algorithm>

namespace overfly {

// A closed stretch of time on the flight's own axis, in seconds. begin_s == end_s is an instant.
struct TimeRange {
    double begin_s = 0.0, end_s = 0.0;

    [[nodiscard]] constexpr double duration_s() const { return end_s - begin_s; }
    [[nodiscard]] constexpr double centre_s() const { return 0.5 * (begin_s + end_s); }
    [[nodiscard]] constexpr bool contains(double t_s) const { return begin_s <= t_s && t_s <= end_s; }
    friend constexpr bool operator==(TimeRange, TimeRange) = default;
};

// The common part; its duration is negative where there is none.
[[nodiscard]] constexpr TimeRange intersection(TimeRange a, TimeRange b) {
    return {std::max(a.begin_s, b.begin_s), std::min(a.end_s, b.end_s)};
}

}  // namespace overfly
