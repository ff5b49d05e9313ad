#include "io/geoid_file.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>

#include "core/error.h"
#include "io/gdal_messages.h"
#include "io/raster_dataset.h"

namespace overfly {
namespace {

// The 15' grid: as Debian's proj-data installs it, and as PROJ's download service calls the same numbers.
constexpr std::array<const char*, 2> kFileNames = {"egm96_15.gtx", "us_nga_egm96_15.tif"};

std::filesystem::path egm96_file() {
    const CPLStringList folders(OSRGetPROJSearchPaths());
    for (int i = 0; i < folders.size(); ++i)
        for (const char* const name : kFileNames)
            if (std::filesystem::path file = std::filesystem::path(folders[i]) / name;
                std::filesystem::is_regular_file(file))
                return file;
    throw UserError({}, fmt::format("heights above sea level need the EGM96 geoid, and {} is in none of PROJ's data "
                                    "folders; install proj-data, or state vertical_datum: ellipsoid",
                                    kFileNames[0]));
}

}  // namespace

Geoid read_egm96() {
    const GdalMessages messages;
    const std::filesystem::path file = egm96_file();
    const RasterDataset dataset = open_raster(file);
    std::array<double, 6> a{};
    GDALRasterBand* const band = dataset->GetRasterBand(1);
    if (dataset->GetGeoTransform(a.data()) != CE_None || !(a[1] > 0.0 && a[5] < 0.0))
        throw UserError({file}, "is not the global grid that it should be");

    Geoid geoid;
    geoid.columns = band->GetXSize();
    geoid.rows = band->GetYSize();
    geoid.step_lon_deg = a[1];
    geoid.step_lat_deg = -a[5];
    geoid.west_deg = a[0] + 0.5 * a[1];
    geoid.north_deg = a[3] + 0.5 * a[5];
    const bool is_global = std::abs(geoid.columns * geoid.step_lon_deg - 360.0) < 1.5 * geoid.step_lon_deg &&
                           std::abs((geoid.rows - 1) * geoid.step_lat_deg - 180.0) < 0.5 * geoid.step_lat_deg;
    if (!is_global) throw UserError({file}, "is not the global grid that it should be");

    geoid.undulation_m.resize(static_cast<std::size_t>(geoid.columns) * static_cast<std::size_t>(geoid.rows));
    if (band->RasterIO(GF_Read, 0, 0, geoid.columns, geoid.rows, geoid.undulation_m.data(), geoid.columns, geoid.rows,
                       GDT_Float32, 0, 0, nullptr) != CE_None)
        throw UserError({file}, "can't be read to the end: " + messages.text());
    return geoid;
}

}  // namespace overfly
