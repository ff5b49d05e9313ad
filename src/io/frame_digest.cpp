#include "io/frame_digest.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "io/frame_facts.h"
#include "io/layer_files.h"

namespace overfly {
namespace {

constexpr std::array<float, 3> kRec709{0.2126F, 0.7152F, 0.0722F};

bool all_zero(std::span<const float> values) {
    return std::ranges::all_of(values, [](float v) { return v == 0.0F; });
}

// How many values are infinite or no number: those whose exponent is all ones.
template <class Bits>
std::size_t not_finite_count(const FrameChannel& channel, Bits exponent) {
    std::size_t count = 0;
    for (std::size_t at = 0; at < channel.values.size(); at += sizeof(Bits)) {
        Bits bits = 0;
        std::memcpy(&bits, channel.values.data() + at, sizeof(Bits));
        count += (bits & exponent) == exponent ? 1 : 0;
    }
    return count;
}

std::size_t not_finite_count(const FrameChannel& channel) {
    switch (channel.type) {
        case ChannelType::Half:
            return not_finite_count(channel, std::uint16_t{0x7c00});
        case ChannelType::Float:
            return not_finite_count(channel, std::uint32_t{0x7f800000});
        case ChannelType::Uint:
            return 0;
    }
    return 0;
}

bool has_statistics(const FrameChannel& channel) {
    constexpr std::array<std::string_view, 5> kNames{"A", "B", "G", "R", "Z"};
    return std::ranges::find(kNames, channel.name) != kNames.end();
}

// Looks at the channels one after another, in the order of their names, since all of them at once would be as much
// again as the frame.
class Digestion {
  public:
    Digestion(int width, int height) : hash_(width, height) {
        digest_.width = width;
        digest_.height = height;
    }

    void take(const FrameChannel& channel) {
        hash_.add(channel);
        const std::size_t bad = not_finite_count(channel);
        if (bad > 0 && digest_.not_finite == 0) digest_.not_finite_channel = channel.name;
        digest_.not_finite += bad;
        if (has_statistics(channel)) take_statistics(channel, bad);
    }

    [[nodiscard]] FrameDigest finish() {
        finish_colours();
        digest_.pixels_sha256 = hex(hash_.digest());
        return std::move(digest_);
    }

  private:
    static constexpr std::array<const char*, 3> kColours{"R", "G", "B"};

    void take_statistics(const FrameChannel& channel, std::size_t bad) {
        const std::vector<float> values = numbers_of(channel);
        const ChannelStatistics s = statistics_of(values);
        const bool any_finite = bad < values.size();
        if (channel.name == "A") {
            digest_.is_black = digest_.is_black || all_zero(values);
            if (any_finite) digest_.statistics.mean_alpha = s.mean;
        }
        if (channel.name == "Z" && any_finite && s.least < static_cast<double>(Frame::kNoDepth))
            digest_.statistics.nearest_m = s.least;
        for (std::size_t i = 0; i < 3; ++i) {
            if (channel.name == kColours[i]) add_colour(values, kRec709[i]);
        }
    }

    void finish_colours() {
        if (colours_ < 3) return;
        digest_.is_black = digest_.is_black || colours_black_ == 3;
        const ChannelStatistics s = statistics_of(luminance_);
        if (s.not_a_number + s.infinite < luminance_.size()) digest_.statistics.luminance = {s.least, s.mean, s.most};
    }

    void add_colour(std::span<const float> values, float weight) {
        luminance_.resize(values.size());
        for (std::size_t p = 0; p < values.size(); ++p) luminance_[p] += weight * values[p];
        ++colours_;
        if (all_zero(values)) ++colours_black_;
    }

    FrameDigest digest_;
    PixelHash hash_;
    std::vector<float> luminance_;
    int colours_ = 0, colours_black_ = 0;
};

FrameDigest digest_of(const FrameChannels& frame) {
    Digestion digestion(frame.width, frame.height);
    for (const FrameChannel& channel : frame.channels) digestion.take(channel);
    return digestion.finish();
}

}  // namespace

FrameDigest digest_of(const StoredChannels& frame) {
    Digestion digestion(frame.width, frame.height);
    std::vector<const StoredChannel*> by_name;
    for (const StoredChannel& channel : frame.channels) by_name.push_back(&channel);
    std::ranges::sort(by_name, {}, &StoredChannel::name);
    const std::size_t pixels = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    for (const StoredChannel* channel : by_name) digestion.take(channel_of(*channel, pixels));
    return digestion.finish();
}

FrameDigest digest_frame(const std::filesystem::path& frame) {
    FrameDigest digest = digest_of(read_all_channels(frame));
    digest.size_bytes = size_of_frame(frame, read_frame_facts(frame).layer_files);
    return digest;
}

}  // namespace overfly
