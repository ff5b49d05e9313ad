#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "film/layers.h"

namespace overfly {

// A channel of a layer. Values of StoredAs::Uint are those whose bits the numbers have.
struct LayerChannel {
    std::string name;
    StoredAs type = StoredAs::Float;
    LayerGroup group = LayerGroup::Data;
    std::vector<float> values;  // of each pixel

    friend bool operator==(const LayerChannel&, const LayerChannel&) = default;
};

// A finished picture: linear light, alpha premultiplied, row 0 at the top.
struct Frame {
    int width = 0, height = 0;
    std::vector<std::array<float, 4>> rgba;
    std::vector<float> depth_m;          // planar; kNoDepth where only sky was seen
    std::vector<LayerChannel> layers{};  // all else that the shot asks for; finite

    // Far beyond any terrain, finite so that compositors can filter it.
    static constexpr float kNoDepth = 1e10F;

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    friend bool operator==(const Frame&, const Frame&) = default;
};

}  // namespace overfly
