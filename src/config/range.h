#pragma once

#include <limits>
#include <string>

namespace overfly::config {

// The numbers that a key allows. Never contains infinities and NaN.
struct Range {
    double low = -std::numeric_limits<double>::max();
    double high = std::numeric_limits<double>::max();
    bool low_allowed = true;

    [[nodiscard]] static Range above(double low, double high) { return {low, high, false}; }
    [[nodiscard]] bool contains(double value) const {
        return (low_allowed ? low <= value : low < value) && value <= high;
    }
    [[nodiscard]] std::string text() const;  // "1 to 65536", "above 0, up to 1"
};

}  // namespace overfly::config
