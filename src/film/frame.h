#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace overfly {

// A finished picture: linear light, alpha premultiplied, row 0 at the top.
struct Frame {
    int width = 0, height = 0;
    std::vector<std::array<float, 4>> rgba;
    std::vector<float> depth_m;  // planar; kNoDepth where only sky was seen

    // Far beyond any terrain, finite so that compositors can filter it.
    static constexpr float kNoDepth = 1e10F;

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    friend bool operator==(const Frame&, const Frame&) = default;
};

}  // namespace overfly
