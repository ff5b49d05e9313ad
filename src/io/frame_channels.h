#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/sha256.h"

namespace overfly {

// As a file holds them; numbers are little-endian.
enum class ChannelType { Half, Float, Uint };

[[nodiscard]] const char* name_of(ChannelType type);  // "half", "float", "uint"

struct FrameChannel {
    std::string name;  // "R", "forward.u"; "PART/R" where an earlier part of the file has an R as well
    ChannelType type = ChannelType::Half;
    std::string compression;        // of the part that it is in, by OpenEXR's name: "zip"
    std::vector<std::byte> values;  // row by row from the top
};

// All that an OpenEXR file holds, of all its parts, whatever its layers are.
struct FrameChannels {
    int width = 0, height = 0;
    std::vector<FrameChannel> channels;  // by name, in the order of its bytes

    // Nothing where there is no such channel.
    [[nodiscard]] const FrameChannel* find(std::string_view name) const;
};

// Reads a file to its last line. Throws UserError: no such file, not OpenEXR, cut off, damaged; deep, or with channels
// that have fewer values than pixels; parts that differ in size.
[[nodiscard]] FrameChannels read_channels(const std::filesystem::path& file);

// SHA-256 of the pixels, whatever compression and parts hold them: of the text "WIDTHxHEIGHT\n", and then for each
// channel, in order, of the text "NAME TYPE\n" and the values.
[[nodiscard]] Sha256Digest pixel_hash(const FrameChannels& frame);

// The same, one channel after another. REQUIRES: in the order of names.
class PixelHash {
  public:
    PixelHash(int width, int height);
    void add(const FrameChannel& channel);
    [[nodiscard]] Sha256Digest digest() { return hash_.digest(); }

  private:
    void add_text(const std::string& text);

    Sha256 hash_;
};

// The values of a channel as numbers; a uint above 2^24 is rounded.
[[nodiscard]] std::vector<float> numbers_of(const FrameChannel& channel);

// Of the values of a channel that are finite; all 0 where none is.
struct ChannelStatistics {
    double least = 0.0, mean = 0.0, most = 0.0;
    std::size_t not_a_number = 0, infinite = 0;  // how many values are that
};

[[nodiscard]] ChannelStatistics statistics_of(std::span<const float> values);
// Exact for a uint of any size.
[[nodiscard]] ChannelStatistics statistics_of(const FrameChannel& channel);

}  // namespace overfly
