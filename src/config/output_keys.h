#pragma once

#include "config/documents.h"
#include "config/section.h"

namespace overfly::config {

// The section `output` of a shot.
void read_output(Section& section, OutputDocument& output);

}  // namespace overfly::config
