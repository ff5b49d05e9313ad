#pragma once

#include "config/documents.h"
#include "config/section.h"

namespace overfly::config {

// What a body is made of: `mesh`, `polygons` or `outline`. An outline says where the body stands as well.
void read_body_shape(Section& section, BodyDocument& body);

}  // namespace overfly::config
