#include "config/layer_keys.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "config/nearest_word.h"

namespace overfly::config {
namespace {

// Negative values of a raster are no classes: a reader of rasters says -1 where there is none.
constexpr Range kClassValue{0, std::numeric_limits<int>::max()};

std::vector<std::string> known_layers() {
    std::vector<std::string> names = {"all", "light", "geo"};
    for (const LayerKind& kind : layer_kinds()) names.emplace_back(kind.name);
    return names;
}

void read_layer(const Node& node, const std::string& path, std::vector<Problem>& problems, LayerSet& layers) {
    const std::optional<LayerSet> named =
        node.kind == Node::Kind::Scalar ? layers_named(node.scalar) : std::optional<LayerSet>();
    if (named) return layers.add(*named);
    const std::vector<std::string> known = known_layers();
    // From one character every other is one step away: N is near to all of them.
    const bool is_word = node.scalar.size() > 1;
    const std::optional<std::string> meant = is_word ? nearest_word(node.scalar, known) : std::optional<std::string>();
    problems.push_back(refusal(path, node,
                               fmt::format("{} or {}{}", fmt::join(std::span(known).first(known.size() - 1), ", "),
                                           known.back(), meant ? fmt::format("; did you mean '{}'?", *meant) : "")));
}

std::optional<int> class_value(const std::string& key) {
    Node number;
    number.kind = Node::Kind::Scalar;
    number.scalar = key;
    const std::optional<double> value = number_of(number);
    if (!value || !kClassValue.contains(*value) || *value != std::trunc(*value)) return std::nullopt;
    return static_cast<int>(*value);
}

void read_names(const Node& node, const std::string& path, std::vector<Problem>& problems,
                std::map<int, std::string>& names) {
    if (node.kind != Node::Kind::Mapping) {
        problems.push_back(refusal(path, node, "a mapping of values to names, as {11: water}"));
        return;
    }
    for (const auto& [key, place, name] : node.entries) {
        const std::optional<int> value = class_value(key);
        if (!value) {
            problems.push_back({place, fmt::format("{}: got {}, allowed a value of the raster, a whole number, {}",
                                                   path, in_quotes(key), kClassValue.text())});
        } else if (name.kind != Node::Kind::Scalar || name.scalar.empty()) {
            problems.push_back(refusal(fmt::format("{}.{}", path, key), name, "a name"));
        } else if (!names.emplace(*value, name.scalar).second) {
            problems.push_back({place, fmt::format("{}: got value {} twice, allowed once", path, *value)});
        }
    }
}

}  // namespace

void read_layers(Section& document, LayerSet& layers) {
    document.read_node("layers", [&](const Node& node, const std::string& path, std::vector<Problem>& problems) {
        if (node.kind != Node::Kind::List) return read_layer(node, path, problems, layers);
        for (std::size_t i = 0; i < node.items.size(); ++i)
            read_layer(node.items[i], fmt::format("{}.{}", path, i), problems, layers);
    });
}

void read_classes(Section& document, std::optional<ClassesDocument>& classes) {
    ClassesDocument read;
    const bool is_there = document.section("classes", [&](Section& section) {
        section.require({"raster"});
        section.read("raster", read.raster, PathTo::Raster);
        section.read("band", read.band, {1, 65536});
        section.read_node("names", [&](const Node& node, const std::string& path, std::vector<Problem>& problems) {
            read_names(node, path, problems, read.names);
        });
    });
    if (is_there) classes = std::move(read);
}

}  // namespace overfly::config
