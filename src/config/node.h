#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace overfly::config {

// A YAML document as plain values: aliases are expanded, every part knows where it came from, and both pairs of a
// duplicate key are kept so that they can be reported.
struct Node {
    enum class Kind { Nothing, Scalar, List, Mapping };
    struct Entry;

    Kind kind = Kind::Nothing;
    std::string scalar;          // Scalar: as written, without quotes
    std::vector<Node> items;     // List
    std::vector<Entry> entries;  // Mapping, in the order of the document
    Place place;                 // of an override: `--set key=value`, without line and column

    [[nodiscard]] static Node nothing(Place place);
    [[nodiscard]] bool from_override() const { return place.line == 0; }

    // The first value of `key`, or nothing where this isn't a mapping that has it.
    [[nodiscard]] const Node* find(std::string_view key) const;
    [[nodiscard]] Node* find(std::string_view key);
};

struct Node::Entry {
    std::string key;
    Place place;
    Node value;
};

// A text with `?` for each control character: what would break a message up, or reach the terminal as a command.
[[nodiscard]] std::string on_one_line(std::string text);

// A text as messages show it: in single quotes, of moderate length, on one line and without control characters.
[[nodiscard]] std::string in_quotes(std::string_view text);

// What a message says after "got": nothing, 12, 'abc', a list, a mapping.
[[nodiscard]] std::string description(const Node& node);

// "path: got ..., allowed ..." at the node.
[[nodiscard]] Problem refusal(std::string_view path, const Node& node, std::string_view allowed);

// The number that a scalar spells: decimal, or .inf, .nan in YAML's spellings and the usual ones. Too large to hold is
// infinite.
[[nodiscard]] std::optional<double> number_of(const Node& node);

}  // namespace overfly::config
