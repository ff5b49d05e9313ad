#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "geo/frames.h"

namespace overfly {

// A raster whose numbers are kinds of ground: land cover, masks, numbers of fields.

// All files that reading it would read: the raster, its side files, the parts of a VRT. Opens it, but reads no values.
// Throws UserError for one that can't be opened.
[[nodiscard]] std::vector<std::filesystem::path> class_raster_inputs(const std::filesystem::path& file);

inline constexpr int kNoClass = -1;

// What the raster says of each place: the value of the pixel that it lies in. kNoClass outside of the raster, where it
// has no data, and for negative values. Heights do not matter. Reads the part of the raster that the places are in, and
// of that a few million pixels at a time, whatever the raster's format and CRS; several threads find the places.
// Throws UserError that names the file: not to be opened, no such band, no CRS or no transformation to it, no
// placement; a palette is fine, numbers with fractions are not.
[[nodiscard]] std::vector<int> classes_at(const std::filesystem::path& file, int band,
                                          std::span<const Geodetic> places);

}  // namespace overfly
