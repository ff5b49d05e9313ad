#pragma once

#include <vector>

#include "core/library_version.h"

namespace overfly {

// GDAL, PROJ, OpenEXR, OpenImageIO, OpenColorIO, Assimp.
[[nodiscard]] std::vector<LibraryVersion> io_library_versions();

}  // namespace overfly
