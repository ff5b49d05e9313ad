#pragma once

#include <vector>

#include "io/elevation_raster.h"

namespace overfly {

// Joins rasters into one. They must have the same CRS, the same spacing and samples in the same places, as tiles of one
// survey have; heights are never resampled. Types, units and no-data values may differ. Where they overlap, the first
// raster that measured a sample gives it; what no raster covers is masked. One raster comes back as it is. REQUIRES: at
// least one. Throws UserError that says which file differs from the first one, and how.
[[nodiscard]] ElevationRaster join_rasters(std::vector<ElevationRaster> rasters);

}  // namespace overfly
