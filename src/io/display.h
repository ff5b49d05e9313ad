#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "film/frame.h"
#include "io/view_transform.h"

namespace overfly {

// A picture as a screen shows it: 8 bits, red, green, blue, row 0 at the top.
struct DisplayImage {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb = {};

    [[nodiscard]] std::size_t index(int x, int y) const {
        return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
    }
    friend bool operator==(const DisplayImage&, const DisplayImage&) = default;
};

// The frame's colours as `view` shows them. What is transparent shows black behind it.
[[nodiscard]] DisplayImage display_image(const Frame& frame, const ViewTransform& view = {});

}  // namespace overfly
