#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "film/frame.h"

namespace overfly {

// A picture as a screen shows it: sRGB, 8 bits, red, green, blue, row 0 at the top.
struct DisplayImage {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb = {};

    [[nodiscard]] std::size_t index(int x, int y) const {
        return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    }
    friend bool operator==(const DisplayImage&, const DisplayImage&) = default;
};

// Linear light as it is up to 0.8; above that highlights approach 1 instead of being cut off.
// GUARANTEES: monotonous, below or at 1, with a continuous slope; what is negative becomes 0.
[[nodiscard]] float soft_highlight(float linear);

// The frame's colours through soft_highlight and the sRGB transfer. What is transparent shows black behind it.
[[nodiscard]] DisplayImage display_image(const Frame& frame);

}  // namespace overfly
