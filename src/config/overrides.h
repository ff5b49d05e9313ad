#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/node.h"
#include "core/error.h"

namespace overfly::config {

// `--set key.subkey=value`, taken apart.
struct Override {
    std::vector<std::string> keys;  // at least one; list items by index from 0
    Node value;
    Place place;  // shown as the command line that gave it
};

// Takes each text apart; one that is not `key.subkey=value` with a YAML value is a problem and left out.
[[nodiscard]] std::vector<Override> parse_overrides(std::span<const std::string> texts, std::vector<Problem>& problems);

// Splits off the overrides of keys inside `prefix`, as the document behind that key sees them: `prefix.a=1` is `a=1`
// there. An override of `prefix` itself stays.
[[nodiscard]] std::vector<Override> take_overrides_inside(std::string_view prefix, std::vector<Override>& overrides);

// Puts a value into a document. Mappings on the way that are missing are made: whether their keys are known is for the
// reader to say. A way through a scalar or past the end of a list is a problem.
void apply_override(const Override& change, Node& document, std::vector<Problem>& problems);

}  // namespace overfly::config
