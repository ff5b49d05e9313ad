#include "io/stored_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

#include <Imath/half.h>

#include "core/error.h"

namespace overfly {
namespace {

constexpr float kLargestHalf = 65504.0F;

std::uint16_t half_of(float value) { return Imath::half(std::clamp(value, -kLargestHalf, kLargestHalf)).bits(); }

// What is not a number is a bug of ours, and would spread through every filter that touches it.
void check_finite(std::span<const float> values, const std::string& channel) {
    const bool are_finite = std::ranges::all_of(values, [](float v) { return std::isfinite(v); });
    if (!are_finite) throw InternalError("the values of a frame's channel are finite: " + channel);
}

template <class Predicate>
StoredChannels chosen(const StoredChannels& all, const Predicate& is_wanted) {
    StoredChannels some{all.width, all.height, {}};
    std::ranges::copy_if(all.channels, std::back_inserter(some.channels), is_wanted);
    return some;
}

template <class Value>
const std::byte* bytes_at(const Value* values) {
    return std::as_bytes(std::span(values, 1)).data();
}

}  // namespace

StoredPixels::StoredPixels(const Frame& frame) : all_{frame.width, frame.height, {}} {
    const std::size_t pixel_count = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    check(frame.width > 0 && frame.height > 0, "a frame has pixels");
    check(frame.rgba.size() == pixel_count && frame.depth_m.size() == pixel_count, "a frame has all its pixels");
    add_colours(frame);
    add_depth(frame);
    halves_.reserve(frame.layers.size());
    for (const LayerChannel& channel : frame.layers) {
        check(channel.values.size() == pixel_count, "a frame's layer has all its pixels");
        add_layer(channel);
    }
}

void StoredPixels::add_colours(const Frame& frame) {
    rgba_.reserve(frame.rgba.size());
    for (const auto& rgba : frame.rgba) {
        std::array<std::uint16_t, 4>& pixel = rgba_.emplace_back();
        for (std::size_t channel = 0; channel < 4; ++channel) {
            check(std::isfinite(rgba[channel]), "a frame's colours are finite");
            pixel[channel] = half_of(rgba[channel]);
        }
    }
    constexpr std::array<const char*, 4> kColours{"R", "G", "B", "A"};
    for (std::size_t c = 0; c < kColours.size(); ++c) {
        all_.channels.push_back({kColours[c], ChannelType::Half, LayerGroup::Beauty, std::nullopt,
                                 bytes_at(rgba_.front().data() + c), sizeof(rgba_[0])});
    }
}

void StoredPixels::add_depth(const Frame& frame) {
    check_finite(frame.depth_m, "Z");
    all_.channels.push_back(
        {"Z", ChannelType::Float, LayerGroup::Data, std::nullopt, bytes_at(frame.depth_m.data()), sizeof(float)});
}

void StoredPixels::add_layer(const LayerChannel& channel) {
    const std::optional<Layer> layer = layer_of_channel(channel.name);
    check(layer.has_value(), "a frame's layer has the name of one");
    StoredChannel stored{channel.name, ChannelType::Float, channel.group, layer, bytes_at(channel.values.data()),
                         sizeof(float)};
    if (channel.type == StoredAs::Uint) {
        stored.type = ChannelType::Uint;
    } else {
        check_finite(channel.values, channel.name);
    }
    if (channel.type == StoredAs::Half) {
        std::vector<std::uint16_t>& halves = halves_.emplace_back(channel.values.size());
        std::ranges::transform(channel.values, halves.begin(), half_of);
        stored.type = ChannelType::Half;
        stored.first = bytes_at(halves.data());
        stored.stride = sizeof(std::uint16_t);
    }
    all_.channels.push_back(std::move(stored));
}

StoredChannels StoredPixels::of(LayerGroup group) const {
    return chosen(all_, [&](const StoredChannel& c) { return c.group == group; });
}

StoredChannels StoredPixels::of(Layer layer) const {
    return chosen(all_, [&](const StoredChannel& c) { return c.layer == layer; });
}

StoredChannels StoredPixels::without(LayerSet layers) const {
    return chosen(all_, [&](const StoredChannel& c) { return !c.layer || !layers.has(*c.layer); });
}

FrameChannel channel_of(const StoredChannel& stored, std::size_t pixels) {
    const std::size_t bytes = stored.type == ChannelType::Half ? sizeof(std::uint16_t) : sizeof(float);
    FrameChannel channel{stored.name, stored.type, {}, std::vector<std::byte>(pixels * bytes)};
    if (stored.stride == bytes) {
        std::memcpy(channel.values.data(), stored.first, channel.values.size());
        return channel;
    }
    for (std::size_t i = 0; i < pixels; ++i)
        std::memcpy(channel.values.data() + i * bytes, stored.first + i * stored.stride, bytes);
    return channel;
}

}  // namespace overfly
