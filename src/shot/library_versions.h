#pragma once

#include <vector>

#include "core/library_version.h"

namespace overfly {

// Of all libraries that the program renders with.
[[nodiscard]] std::vector<LibraryVersion> all_library_versions();

}  // namespace overfly
