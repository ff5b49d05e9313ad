#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "film/frame.h"
#include "io/frame_channels.h"

namespace overfly {

// A channel as its file holds it: a value for each pixel, row by row from the top. Looks at values that others own.
struct StoredChannel {
    std::string name;
    ChannelType type = ChannelType::Half;
    LayerGroup group = LayerGroup::Beauty;
    std::optional<Layer> layer;        // none: R, G, B, A or Z
    const std::byte* first = nullptr;  // of the upper left pixel
    std::size_t stride = 0;            // bytes from one pixel to the next
};

// Some of a frame's channels, for one file or one part of it.
struct StoredChannels {
    int width = 0, height = 0;
    std::vector<StoredChannel> channels;
};

// A frame's pixels in the types in which its files hold them. Looks at the frame, which must outlive it.
class StoredPixels {
  public:
    // REQUIRES: all values are finite, but for those of StoredAs::Uint. What is beyond the range of half (65504)
    // becomes its end. Channels of layers have the names of layer_kinds().
    explicit StoredPixels(const Frame& frame);
    StoredPixels(const StoredPixels&) = delete;
    StoredPixels& operator=(const StoredPixels&) = delete;
    ~StoredPixels() = default;

    [[nodiscard]] const StoredChannels& all() const { return all_; }
    [[nodiscard]] StoredChannels of(LayerGroup group) const;
    [[nodiscard]] StoredChannels of(Layer layer) const;
    [[nodiscard]] StoredChannels without(LayerSet layers) const;

  private:
    void add_colours(const Frame& frame);
    void add_depth(const Frame& frame);
    void add_layer(const LayerChannel& channel);

    std::vector<std::array<std::uint16_t, 4>> rgba_;  // bits of half
    std::vector<std::vector<std::uint16_t>> halves_;  // of layers
    StoredChannels all_;
};

// As read_channels would find it in a file, but for its compression.
[[nodiscard]] FrameChannel channel_of(const StoredChannel& channel, std::size_t pixels);

}  // namespace overfly
