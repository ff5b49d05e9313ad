#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/node.h"
#include "core/error.h"

namespace overfly::config {

// Parses one YAML document. Lines and columns are counted from 1 within `origin.file`; where `origin` has no file but
// an override, `origin` is the place of everything in it.
// An empty text is a node of kind Nothing. Broken YAML, more than one document, a key that is not a plain word, and
// aliases that contain themselves or grow without bound each give nothing and one problem.
enum class TextOrigin { File, Override };
[[nodiscard]] std::optional<Node> parse_yaml(const std::string& text, const Place& origin, TextOrigin kind,
                                             std::vector<Problem>& problems);

}  // namespace overfly::config
