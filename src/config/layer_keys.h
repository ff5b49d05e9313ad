#pragma once

#include <optional>

#include "config/documents.h"
#include "config/section.h"

namespace overfly::config {

// The key `layers` of a shot: a word, or a list of words that may be empty.
void read_layers(Section& document, LayerSet& layers);

// The section `classes` of a shot.
void read_classes(Section& document, std::optional<ClassesDocument>& classes);

}  // namespace overfly::config
