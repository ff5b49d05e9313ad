#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "film/layers.h"
#include "io/frame_channels.h"
#include "io/object_coverage.h"

namespace overfly {

// What overfly info tells of a file's pixels: a table of its channels, and of the objects in it.
struct ChannelInfo {
    std::string name;
    std::optional<Layer> layer;
    ChannelType type = ChannelType::Half;
    std::string compression;
    ChannelStatistics statistics;
};

// By name, as the file has them.
[[nodiscard]] std::vector<ChannelInfo> channel_infos(const FrameChannels& frame);

// Layer by layer, with what each of them is.
[[nodiscard]] std::string channel_table(const std::vector<ChannelInfo>& channels);
[[nodiscard]] nlohmann::ordered_json channels_json(const std::vector<ChannelInfo>& channels);

// Empty where there are none.
[[nodiscard]] std::string object_table(const std::vector<ObjectCoverage>& objects);
[[nodiscard]] nlohmann::ordered_json objects_json(const std::vector<ObjectCoverage>& objects);

}  // namespace overfly
