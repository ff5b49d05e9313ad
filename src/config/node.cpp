#include "config/node.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

namespace overfly::config {
namespace {

// Longer texts are cut in messages.
constexpr std::size_t kMaxQuotedLength = 60;

std::optional<double> spelt_number(std::string_view text) {
    const bool plus = text.starts_with('+');
    if (plus) text.remove_prefix(1);
    const bool minus = text.starts_with('-');
    if (plus && minus) return std::nullopt;
    const std::string_view digits = minus ? text.substr(1) : text;
    if (digits == ".inf" || digits == ".Inf" || digits == ".INF") {
        const double infinity = std::numeric_limits<double>::infinity();
        return minus ? -infinity : infinity;
    }
    if (text == ".nan" || text == ".NaN" || text == ".NAN") return std::numeric_limits<double>::quiet_NaN();

    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size()) return std::nullopt;
    if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::infinity();
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

}  // namespace

Node Node::nothing(Place place) {
    Node node;
    node.place = std::move(place);
    return node;
}

const Node* Node::find(std::string_view key) const {
    const auto entry = std::ranges::find(entries, key, &Entry::key);
    return entry == entries.end() ? nullptr : &entry->value;
}

Node* Node::find(std::string_view key) { return const_cast<Node*>(std::as_const(*this).find(key)); }

std::string on_one_line(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 0x20 || c == 0x7F; }, '?');
    return text;
}

std::string in_quotes(std::string_view text) {
    std::size_t length = std::min(text.size(), kMaxQuotedLength);
    // Never through the middle of a UTF-8 character: its bytes after the first are 10xxxxxx.
    while (length > 0 && length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0) == 0x80) --length;
    const std::string shown = on_one_line(std::string(text.substr(0, length)));
    return '\'' + shown + (length < text.size() ? "...'" : "'");
}

std::string description(const Node& node) {
    switch (node.kind) {
        case Node::Kind::Nothing:
            return "nothing";
        case Node::Kind::Scalar:
            return number_of(node) ? node.scalar.substr(0, kMaxQuotedLength) : in_quotes(node.scalar);
        case Node::Kind::List:
            return node.items.empty() ? "an empty list" : "a list";
        case Node::Kind::Mapping:
            return "a mapping";
    }
    throw InternalError("every kind of node has a description");
}

Problem refusal(std::string_view path, const Node& node, std::string_view allowed) {
    const std::string prefix = path.empty() ? "" : std::string(path) + ": ";
    return {node.place, fmt::format("{}got {}, allowed {}", prefix, description(node), allowed)};
}

std::optional<double> number_of(const Node& node) {
    if (node.kind != Node::Kind::Scalar) return std::nullopt;
    return spelt_number(node.scalar);
}

}  // namespace overfly::config
