#pragma once

#include <vector>

#include "core/library_version.h"

namespace overfly {

// yaml-cpp.
[[nodiscard]] std::vector<LibraryVersion> config_library_versions();

}  // namespace overfly
