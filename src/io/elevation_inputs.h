#pragma once

#include <filesystem>
#include <vector>

#include "terrain/elevation_source.h"

namespace overfly {

// All files that reading `source` would read: the rasters, their side files, the parts of a VRT. Opens them, but reads
// no samples. Throws UserError as read_elevation does for files that can't be opened.
[[nodiscard]] std::vector<std::filesystem::path> elevation_inputs(const ElevationSource& source);

}  // namespace overfly
