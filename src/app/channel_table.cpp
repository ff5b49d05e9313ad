#include "app/channel_table.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace overfly {
namespace {

using Json = nlohmann::ordered_json;

bool is_uint(const ChannelInfo& c) { return c.type == ChannelType::Uint; }

// Numbers of objects are names, whose mean would say nothing.
std::string row(const ChannelInfo& c) {
    const ChannelStatistics& s = c.statistics;
    const std::string numbers = is_uint(c) ? fmt::format("{:>13.0f}{:>13}{:>13.0f}", s.least, "", s.most)
                                           : fmt::format("{:>13.6g}{:>13.6g}{:>13.6g}", s.least, s.mean, s.most);
    return fmt::format("{:<19} {:<8}{:<8}{}{:>8}{:>8}\n", c.name, name_of(c.type), c.compression, numbers,
                       s.not_a_number, s.infinite);
}

std::string rows(const std::vector<ChannelInfo>& channels, std::optional<Layer> layer) {
    std::string text;
    for (const ChannelInfo& c : channels) {
        if (c.layer == layer) text += row(c);
    }
    return text;
}

}  // namespace

std::vector<ChannelInfo> channel_infos(const FrameChannels& frame) {
    std::vector<ChannelInfo> infos;
    for (const FrameChannel& c : frame.channels)
        infos.push_back({c.name, layer_of_channel(c.name), c.type, c.compression, statistics_of(c)});
    return infos;
}

std::string channel_table(const std::vector<ChannelInfo>& channels) {
    std::string text = fmt::format("\n{:<20}{:<8}{:<8}{:>13}{:>13}{:>13}{:>8}{:>8}\n", "channel", "type", "stored",
                                   "min", "mean", "max", "NaN", "inf");
    text += rows(channels, std::nullopt);
    for (const LayerKind& kind : layer_kinds()) {
        const std::string layer = rows(channels, kind.layer);
        if (!layer.empty()) text += fmt::format("\n{}: {}\n{}", kind.name, kind.meaning, layer);
    }
    return text;
}

Json channels_json(const std::vector<ChannelInfo>& channels) {
    Json json = Json::array();
    for (const ChannelInfo& c : channels) {
        const ChannelStatistics& s = c.statistics;
        Json one = {{"name", c.name}, {"type", name_of(c.type)}, {"compression", c.compression}};
        one["layer"] = c.layer ? Json(kind_of(*c.layer).name) : Json();
        if (is_uint(c)) {
            one["min"] = static_cast<std::uint64_t>(s.least);
            one["mean"] = Json();
            one["max"] = static_cast<std::uint64_t>(s.most);
        } else {
            one["min"] = s.least;
            one["mean"] = s.mean;
            one["max"] = s.most;
        }
        one["nan"] = s.not_a_number;
        one["infinite"] = s.infinite;
        json.push_back(std::move(one));
    }
    return json;
}

std::string object_table(const std::vector<ObjectCoverage>& objects) {
    if (objects.empty()) return "";
    std::string text = fmt::format("\n{:<46}{:>13}\n", "object", "coverage");
    for (const ObjectCoverage& o : objects) text += fmt::format("{:<45} {:>13.6f}\n", o.name, o.share);
    return text;
}

Json objects_json(const std::vector<ObjectCoverage>& objects) {
    Json json = Json::array();
    for (const ObjectCoverage& o : objects) json.push_back({{"name", o.name}, {"coverage", o.share}});
    return json;
}

}  // namespace overfly
