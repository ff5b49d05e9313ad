#include "config/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <utility>

#include "config/yaml_text.h"

namespace overfly::config {
namespace {

std::vector<std::string> split_keys(std::string_view text) {
    std::vector<std::string> keys;
    for (;;) {
        const std::size_t dot = text.find('.');
        keys.emplace_back(text.substr(0, dot));
        if (dot == std::string_view::npos) return keys;
        text.remove_prefix(dot + 1);
    }
}

std::optional<std::size_t> index_of(std::string_view key) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
    const bool whole = error == std::errc() && end == key.data() + key.size();
    return whole ? std::optional(index) : std::nullopt;
}

// The value of `key` inside `parent`, made where it is missing. Throws UserError where there can't be one; `path` is
// that of the parent.
Node& child(Node& parent, const std::string& key, const std::string& path, const Place& place) {
    if (parent.kind == Node::Kind::List) {
        const std::optional<std::size_t> index = index_of(key);
        if (index && *index < parent.items.size()) return parent.items[*index];
        const std::size_t count = parent.items.size();
        throw UserError(place, fmt::format("{}: got item {}, allowed {}", path, in_quotes(key),
                                           count == 0   ? "none: the list is empty"
                                           : count == 1 ? "0, the only one"
                                                        : fmt::format("0 to {}", count - 1)));
    }
    if (parent.kind == Node::Kind::Scalar) {
        throw UserError(place, fmt::format("{}: got {} inside of {}, allowed nothing inside of a plain value", path,
                                           in_quotes(key), description(parent)));
    }
    if (Node* value = parent.find(key)) return *value;
    parent.kind = Node::Kind::Mapping;
    parent.entries.push_back({key, place, Node::nothing(place)});
    return parent.entries.back().value;
}

}  // namespace

std::vector<Override> parse_overrides(std::span<const std::string> texts, std::vector<Problem>& problems) {
    std::vector<Override> overrides;
    for (const std::string& text : texts) {
        const Place place{"--set " + on_one_line(text)};
        const std::size_t equals = text.find('=');
        std::vector<std::string> keys = split_keys(std::string_view(text).substr(0, equals));
        if (equals == std::string::npos || std::ranges::any_of(keys, &std::string::empty)) {
            problems.push_back({place, "got no key and value, allowed key.subkey=value"});
            continue;
        }
        std::optional<Node> value = parse_yaml(text.substr(equals + 1), place, TextOrigin::Override, problems);
        if (value) overrides.push_back({std::move(keys), std::move(*value), place});
    }
    return overrides;
}

std::vector<Override> take_overrides_inside(std::string_view prefix, std::vector<Override>& overrides) {
    const auto inside = std::stable_partition(overrides.begin(), overrides.end(), [&](const Override& o) {
        return o.keys.size() == 1 || o.keys.front() != prefix;
    });
    std::vector<Override> taken(std::make_move_iterator(inside), std::make_move_iterator(overrides.end()));
    overrides.erase(inside, overrides.end());
    for (Override& o : taken) o.keys.erase(o.keys.begin());
    return taken;
}

void apply_override(const Override& change, Node& document, std::vector<Problem>& problems) {
    try {
        Node* node = &document;
        std::string path;
        for (const std::string& key : change.keys) {
            node = &child(*node, key, path, change.place);
            path += (path.empty() ? "" : ".") + key;
        }
        *node = change.value;
    } catch (const UserError& e) {
        problems.insert(problems.end(), e.problems().begin(), e.problems().end());
    }
}

}  // namespace overfly::config
