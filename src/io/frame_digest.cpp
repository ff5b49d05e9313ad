#include "io/frame_digest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>
#include <vector>

#include "film/frame.h"

namespace overfly {
namespace {

constexpr std::array<float, 3> kRec709{0.2126F, 0.7152F, 0.0722F};

bool all_zero(std::span<const float> values) {
    return std::ranges::all_of(values, [](float v) { return v == 0.0F; });
}

// Looks at the channels one after another, since all of them as numbers at once would be twice the frame.
class Digestion {
  public:
    explicit Digestion(FrameDigest& digest) : digest_(&digest) {}

    void take(const FrameChannel& channel) {
        const std::vector<float> values = numbers_of(channel);
        const ChannelStatistics s = statistics_of(values);
        const std::size_t bad = s.not_a_number + s.infinite;
        if (bad > 0 && digest_->not_finite == 0) digest_->not_finite_channel = channel.name;
        digest_->not_finite += bad;
        const bool any_finite = bad < values.size();
        if (channel.name == "A") {
            digest_->is_black = digest_->is_black || all_zero(values);
            if (any_finite) digest_->statistics.mean_alpha = s.mean;
        }
        if (channel.name == "Z" && any_finite && s.least < static_cast<double>(Frame::kNoDepth))
            digest_->statistics.nearest_m = s.least;
        for (std::size_t i = 0; i < 3; ++i) {
            if (channel.name == kColours[i]) add_colour(values, kRec709[i]);
        }
    }

    void finish() {
        if (colours_ < 3) return;
        digest_->is_black = digest_->is_black || colours_black_ == 3;
        const ChannelStatistics s = statistics_of(luminance_);
        if (s.not_a_number + s.infinite < luminance_.size()) digest_->statistics.luminance = {s.least, s.mean, s.most};
    }

  private:
    static constexpr std::array<const char*, 3> kColours{"R", "G", "B"};

    void add_colour(std::span<const float> values, float weight) {
        luminance_.resize(values.size());
        for (std::size_t p = 0; p < values.size(); ++p) luminance_[p] += weight * values[p];
        ++colours_;
        if (all_zero(values)) ++colours_black_;
    }

    FrameDigest* digest_;
    std::vector<float> luminance_;
    int colours_ = 0, colours_black_ = 0;
};

}  // namespace

FrameDigest digest_of(const FrameChannels& frame) {
    FrameDigest digest;
    digest.width = frame.width;
    digest.height = frame.height;
    digest.pixels_sha256 = hex(pixel_hash(frame));
    Digestion digestion(digest);
    for (const FrameChannel& channel : frame.channels) digestion.take(channel);
    digestion.finish();
    return digest;
}

FrameDigest digest_frame(const std::filesystem::path& file) {
    FrameDigest digest = digest_of(read_channels(file));
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    digest.size_bytes = error ? 0 : size;
    return digest;
}

}  // namespace overfly
