#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "io/stored_pixels.h"

namespace overfly {

// What a frame looks like, in a few numbers. Nothing where it has not the channels for it, or no finite value in them.
struct FrameStatistics {
    struct Luminance {
        double least = 0.0, mean = 0.0, most = 0.0;
        friend bool operator==(const Luminance&, const Luminance&) = default;
    };
    std::optional<Luminance> luminance;  // of R, G, B, by the weights of Rec. 709
    std::optional<double> mean_alpha;    // of A
    std::optional<double> nearest_m;     // of Z, where anything but sky is seen

    friend bool operator==(const FrameStatistics&, const FrameStatistics&) = default;
};

// A frame's content without its pixels: all of it, whatever layers have files of their own.
struct FrameDigest {
    std::uint64_t size_bytes = 0;  // of its files
    int width = 0, height = 0;
    std::string pixels_sha256;  // pixel_hash of all channels, in hexadecimal
    FrameStatistics statistics;
    bool is_black = false;           // R, G, B are 0 throughout, or A is
    std::size_t not_finite = 0;      // how many values of all channels are infinite or no number
    std::string not_finite_channel;  // the first that has one
};

// Without the files' size. Whoever has a frame in memory and stores it without loss need not read it back.
[[nodiscard]] FrameDigest digest_of(const StoredChannels& frame);

// Reads the frame's file whole, and those of its layers. Throws UserError as read_all_channels does.
[[nodiscard]] FrameDigest digest_frame(const std::filesystem::path& frame);

}  // namespace overfly
