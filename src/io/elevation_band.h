#pragma once

#include <filesystem>
#include <optional>

#include "terrain/elevation_model.h"

class GDALRasterBand;

namespace overfly {

// Reads all samples of a band as metres: its scale and offset, then `metres_per_unit`. Masked are: no-data (`no_data`
// where given, else the band's own), what the band's mask leaves out, and what is no number.
// Throws UserError that names `file` and says GDAL's words when the data can't be read to the end.
[[nodiscard]] ElevationModel read_band(GDALRasterBand& band, std::optional<double> no_data, double metres_per_unit,
                                       const std::filesystem::path& file);

// `stated` where there is one, else the band's own.
[[nodiscard]] std::optional<double> no_data_of(GDALRasterBand& band, std::optional<double> stated);

}  // namespace overfly
