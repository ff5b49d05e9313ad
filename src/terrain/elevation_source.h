#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace overfly {

// What heights in a raster are counted from. Unstated: what the file's own CRS says, sea level (EGM96) where it says
// nothing.
enum class VerticalDatum { Unstated, Egm96, Ellipsoid, Offset };

// Which rasters make one terrain, and how to read their numbers where the files themselves are silent or wrong.
struct ElevationSource {
    std::vector<std::filesystem::path> dem{};  // at least one; several are mosaicked
    std::optional<int> band{};                 // from 1; none: the files have just one
    std::string crs{};                         // anything GDAL understands; empty: the files' own
    std::optional<double> no_data{};           // none: the files' own
    std::string vertical_unit{};               // m, km, ft, us-ft ...; empty: the band's own, metres if it has none
    VerticalDatum vertical_datum = VerticalDatum::Unstated;
    double vertical_offset_m = 0.0;  // with Offset: ellipsoidal height = height + offset

    friend bool operator==(const ElevationSource&, const ElevationSource&) = default;
};

}  // namespace overfly
