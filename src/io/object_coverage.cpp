#include "io/object_coverage.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>

#include "film/cryptomatte.h"
#include "film/layers.h"

namespace overfly {
namespace {

using Shares = std::map<std::uint32_t, double>;  // in pixels

std::vector<std::uint32_t> numbers_of_objects(const FrameChannel& channel) {
    std::vector<std::uint32_t> numbers(channel.values.size() / sizeof(std::uint32_t));
    std::memcpy(numbers.data(), channel.values.data(), numbers.size() * sizeof(std::uint32_t));
    return numbers;
}

// Channels of four bytes only: halves are none of ours.
const FrameChannel* wide_channel(const FrameChannels& frame, std::string_view name) {
    const FrameChannel* const channel = frame.find(name);
    return channel == nullptr || channel->type == ChannelType::Half ? nullptr : channel;
}

void add_rank(const FrameChannels& frame, std::string_view object, std::string_view share, Shares& shares) {
    const FrameChannel* const objects = wide_channel(frame, object);
    const FrameChannel* const weights = wide_channel(frame, share);
    if (objects == nullptr || weights == nullptr) return;
    const std::vector<std::uint32_t> numbers = numbers_of_objects(*objects);
    const std::vector<float> values = numbers_of(*weights);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] != 0) shares[numbers[i]] += static_cast<double>(values[i]);
    }
}

Shares shares_of(const FrameChannels& frame) {
    Shares shares;
    const std::span<const std::string_view> ranks = kind_of(Layer::Cryptomatte).channels;
    for (std::size_t i = 0; i + 1 < ranks.size(); i += 2) add_rank(frame, ranks[i], ranks[i + 1], shares);
    if (!shares.empty()) return shares;
    const FrameChannel* const most = wide_channel(frame, kind_of(Layer::Id).channels.front());
    if (most == nullptr) return shares;
    for (const std::uint32_t number : numbers_of_objects(*most)) {
        if (number != 0) shares[number] += 1.0;
    }
    return shares;
}

std::map<std::string, std::string> names_by_digits(const std::string& manifest) {
    std::map<std::string, std::string> names;
    const nlohmann::json json = nlohmann::json::parse(manifest, nullptr, false);
    if (!json.is_object()) return names;
    for (const auto& [name, digits] : json.items()) {
        if (digits.is_string()) names.try_emplace(digits.get<std::string>(), name);
    }
    return names;
}

}  // namespace

std::vector<ObjectCoverage> object_coverage(const FrameChannels& frame, const std::string& manifest) {
    const std::map<std::string, std::string> names = names_by_digits(manifest);
    const double pixels = static_cast<double>(frame.width) * static_cast<double>(frame.height);
    std::vector<ObjectCoverage> objects;
    for (const auto& [number, share] : shares_of(frame)) {
        const std::string digits = cryptomatte_hex(number);
        const auto known = names.find(digits);
        objects.push_back({known == names.end() ? digits : known->second, share / pixels});
    }
    std::ranges::stable_sort(objects, std::greater(), &ObjectCoverage::share);
    return objects;
}

}  // namespace overfly
