#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "film/frame_storage.h"
#include "io/frame_file.h"
#include "io/stored_pixels.h"

namespace overfly {

// Where the bytes of a file go.
class ByteSink {
  public:
    virtual ~ByteSink() = default;
    virtual void write(std::span<const std::byte> bytes) = 0;
    virtual void seek(std::uint64_t offset) = 0;
    [[nodiscard]] virtual std::uint64_t position() const = 0;
};

// An OpenEXR file of a frame's channels, or of some of them: one part where they are of one group, or all groups are
// compressed alike; else a part for each, the first of which is `beauty`. All parts carry the whole header.
// REQUIRES: storage.data is lossless.
void encode_frame(const StoredChannels& pixels, const FrameHeader& header, const FrameStorage& storage, ByteSink& sink);

}  // namespace overfly
