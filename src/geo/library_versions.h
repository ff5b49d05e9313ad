#pragma once

#include <vector>

#include "core/library_version.h"

namespace overfly {

// GeographicLib.
[[nodiscard]] std::vector<LibraryVersion> geo_library_versions();

}  // namespace overfly
