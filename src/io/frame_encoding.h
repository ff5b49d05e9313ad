#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "film/frame.h"
#include "film/frame_storage.h"
#include "io/frame_channels.h"
#include "io/frame_file.h"

namespace overfly {

// A frame's pixels in the types in which its file holds them. Looks at the frame, which must outlive it.
struct StoredPixels {
    int width = 0, height = 0;
    std::vector<std::array<std::uint16_t, 4>> rgba;  // bits of half
    std::span<const float> depth_m;
};

// REQUIRES: colours and depths are finite. A colour beyond the range of half (65504) becomes its end.
[[nodiscard]] StoredPixels stored_pixels(const Frame& frame);

// As read_channels would find them in a file.
[[nodiscard]] FrameChannels channels_of(const StoredPixels& pixels);

// Where the bytes of a file go.
class ByteSink {
  public:
    virtual ~ByteSink() = default;
    virtual void write(std::span<const std::byte> bytes) = 0;
    virtual void seek(std::uint64_t offset) = 0;
    [[nodiscard]] virtual std::uint64_t position() const = 0;
};

// The OpenEXR file of a frame: one part where all groups of layers are compressed alike, else a part for each, the
// first of which is `beauty`. All parts carry the whole header.
void encode_frame(const StoredPixels& pixels, const FrameHeader& header, const FrameStorage& storage, ByteSink& sink);

// One group alone, in the same way: what compressing it costs.
void encode_group(const StoredPixels& pixels, const FrameHeader& header, LayerGroup group, const FrameStorage& storage,
                  ByteSink& sink);

}  // namespace overfly
