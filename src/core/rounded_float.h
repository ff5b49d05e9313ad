#pragma once

#include <cmath>
#include <limits>

namespace overfly {

// The nearest float that is not above, or not below, a double.
[[nodiscard]] inline float rounded_down(double v) {
    const auto f = static_cast<float>(v);
    return static_cast<double>(f) <= v ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
[[nodiscard]] inline float rounded_up(double v) { return -rounded_down(-v); }

}  // namespace overfly
