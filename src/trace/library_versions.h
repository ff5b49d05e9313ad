#pragma once

#include <vector>

#include "core/library_version.h"

namespace overfly {

// Embree, Highway (with the vector unit that it chose here).
[[nodiscard]] std::vector<LibraryVersion> trace_library_versions();

}  // namespace overfly
