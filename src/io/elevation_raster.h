#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/vertical_reference.h"
#include "io/vertical_unit.h"
#include "terrain/elevation_model.h"
#include "terrain/elevation_source.h"

namespace overfly {

// GDAL's geotransform: x = [0] + column * [1] + row * [2], y = [3] + column * [4] + row * [5], in the CRS, with columns
// and rows counted from the outer corner of the first sample: its centre is at (0.5, 0.5).
using CrsFromPixel = std::array<double, 6>;

// More samples than half-edges can be numbered for are refused: two triangles each, below 2^30 triangles.
inline constexpr std::size_t kMostSamples = std::size_t{1} << 29;

// One band of one file, as measured.
struct ElevationRaster {
    std::filesystem::path file;                // as the user named it
    std::vector<std::filesystem::path> files;  // everything that was read for it
    std::string driver;
    ElevationModel model;  // metres, counted from vertical.datum
    CrsFromPixel crs_from_pixel{};
    std::string crs_wkt;  // horizontal part, WKT 2
    std::string crs_name, crs_authority;
    std::string crs_unit;  // of crs_from_pixel, "metre" or "degree" mostly
    std::optional<double> no_data;
    VerticalUnit unit;
    Provenance unit_provenance = Provenance::Assumed;
    VerticalReference vertical;
};

// Reads `file` as `source` says. Throws UserError with everything that is wrong with it at once.
[[nodiscard]] ElevationRaster read_elevation_raster(const std::filesystem::path& file, const ElevationSource& source);

}  // namespace overfly
