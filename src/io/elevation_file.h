#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geo/frames.h"
#include "io/sample_locator.h"
#include "io/vertical_reference.h"
#include "io/vertical_unit.h"
#include "terrain/elevation_model.h"
#include "terrain/elevation_source.h"
#include "terrain/triangulate.h"

namespace overfly {

// What was read, and what was taken for granted: for people, and for the document that import writes.
struct ElevationReport {
    std::vector<std::filesystem::path> files;  // all that was read, side files and parts of a VRT too
    std::string driver;                        // GDAL's short name, "GTiff"
    std::string crs_name, crs_authority;       // "WGS 84 / UTM zone 13N", "EPSG:32613"; the latter may be empty
    int columns = 0, rows = 0;
    double column_spacing = 0.0, row_spacing = 0.0;  // in spacing_unit
    std::string spacing_unit;                        // "metre", "degree", ...
    VerticalUnit vertical_unit;
    Provenance vertical_unit_provenance = Provenance::Assumed;
    VerticalReference vertical;
    std::optional<double> no_data;  // as stored
    std::size_t valid_count = 0;
    double no_data_share = 0.0;
    double lowest_m = 0.0, highest_m = 0.0;  // counted from `vertical`
    GeographicExtent extent;

    friend bool operator==(const ElevationReport&, const ElevationReport&) = default;
};

// Elevation as measured, and where on the ellipsoid it is: what triangulate() asks for.
struct ElevationFile {
    std::shared_ptr<const ElevationModel> model;
    // Places of WGS84 with ellipsoidal heights, whatever the raster's CRS and datum. Throws UserError for a measured
    // sample that the CRS gives no place. Shares `model`, and may outlive this struct.
    LocateRow locate;
    Geodetic centre;  // of the raster, on the ellipsoid: a good origin of the scene
    ElevationReport report;
};

// Reads what `source` names with GDAL, joined into one raster. Throws UserError with all that is wrong with the files;
// nothing is printed.
[[nodiscard]] ElevationFile read_elevation(const ElevationSource& source);

}  // namespace overfly
