#pragma once

#include <vector>

#include "core/library_version.h"

namespace overfly {

// GEOS.
[[nodiscard]] std::vector<LibraryVersion> mesh_library_versions();

}  // namespace overfly
