#include "io/elevation_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/error.h"
#include "geo/geoid.h"
#include "io/elevation_raster.h"
#include "io/gdal_messages.h"
#include "io/geoid_file.h"
#include "io/raster_mosaic.h"

namespace overfly {
namespace {

ElevationRaster read_joined(const ElevationSource& source) {
    std::vector<ElevationRaster> rasters;
    std::vector<Problem> problems;
    for (const std::filesystem::path& file : source.dem) {
        try {
            rasters.push_back(read_elevation_raster(file, source));
        } catch (const UserError& error) {
            problems.insert(problems.end(), error.problems().begin(), error.problems().end());
        }
    }
    if (!problems.empty()) throw UserError(std::move(problems));
    return join_rasters(std::move(rasters));
}

// Counts and extremes of what was measured. Throws where nothing was, or where no such place is on Earth.
void measure(const ElevationModel& model, const std::filesystem::path& file, ElevationReport& report) {
    float lowest_m = std::numeric_limits<float>::max(), highest_m = std::numeric_limits<float>::lowest();
    for (std::size_t i = 0; i < model.size(); ++i) {
        if (model.is_valid[i] == 0) continue;
        ++report.valid_count;
        lowest_m = std::min(lowest_m, model.height_m[i]);
        highest_m = std::max(highest_m, model.height_m[i]);
    }
    if (report.valid_count == 0) throw UserError({file}, "has no valid sample, only no-data");
    report.no_data_share = 1.0 - static_cast<double>(report.valid_count) / static_cast<double>(model.size());
    report.lowest_m = static_cast<double>(lowest_m);
    report.highest_m = static_cast<double>(highest_m);

    // The deepest trench is at -10,984 m, the highest summit at 8,849 m. What lies beyond is a void that was never
    // declared as one, or another unit.
    constexpr double kLowest_m = -12'000.0, kHighest_m = 10'000.0;
    if (report.lowest_m < kLowest_m || report.highest_m > kHighest_m)
        throw UserError({file}, fmt::format("heights run from {:g} to {:g} m, which is not on Earth; state no_data: or "
                                            "vertical_unit:",
                                            report.lowest_m, report.highest_m));
}

ElevationReport describe(const ElevationRaster& raster, const SampleLocator& locator) {
    ElevationReport report;
    report.files = raster.files;
    report.driver = raster.driver;
    report.crs_name = raster.crs_name;
    report.crs_authority = raster.crs_authority;
    report.columns = raster.model.columns;
    report.rows = raster.model.rows;
    const CrsFromPixel& a = raster.crs_from_pixel;
    report.column_spacing = std::hypot(a[1], a[4]);
    report.row_spacing = std::hypot(a[2], a[5]);
    report.spacing_unit = raster.crs_unit;
    report.vertical_unit = raster.unit;
    report.vertical_unit_provenance = raster.unit_provenance;
    report.vertical = raster.vertical;
    report.no_data = raster.no_data;
    report.extent = locator.extent();
    measure(raster.model, raster.file, report);
    return report;
}

// Puts the measured samples of a row on the ellipsoid.
class RowLocator {
  public:
    RowLocator(std::shared_ptr<const ElevationModel> model, SampleLocator locator, const ElevationRaster& raster)
        : model_(std::move(model)), locator_(std::move(locator)), file_(raster.file), crs_name_(raster.crs_name) {
        if (raster.vertical.datum == VerticalDatum::Egm96) geoid_ = std::make_shared<const Geoid>(read_egm96());
        if (raster.vertical.datum == VerticalDatum::Offset) offset_m_ = raster.vertical.offset_m;
    }

    void operator()(int row, std::span<Geodetic> places) const {
        // Voids may lie where the CRS has no places, and cost time: only what was measured is looked up.
        std::vector<int> columns;
        std::vector<double> lon_deg, lat_deg;
        for (int column = 0; column < model_->columns; ++column)
            if (model_->is_valid[model_->index(column, row)] != 0) columns.push_back(column);
        lon_deg.assign(columns.begin(), columns.end());
        lat_deg.assign(columns.size(), row);
        locator_.locate(lon_deg, lat_deg);
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (!std::isfinite(lon_deg[i]) || !std::isfinite(lat_deg[i]))
                throw UserError({file_}, fmt::format("the sample in column {}, row {} has no place on Earth in CRS "
                                                     "\"{}\"; state the right one with crs:",
                                                     columns[i], row, crs_name_));
            Geodetic& place = places[static_cast<std::size_t>(columns[i])];
            place.lon = Angle::degrees(lon_deg[i]);
            place.lat = Angle::degrees(lat_deg[i]);
            place.height_m = static_cast<double>(model_->height_m[model_->index(columns[i], row)]) + offset_m_;
            if (geoid_) place.height_m += geoid_->undulation_m_at(place.lon, place.lat);
        }
    }

  private:
    std::shared_ptr<const ElevationModel> model_;
    SampleLocator locator_;
    std::shared_ptr<const Geoid> geoid_;  // none: heights are ellipsoidal but for the offset
    double offset_m_ = 0.0;
    std::filesystem::path file_;
    std::string crs_name_;
};

Geodetic centre_of(const ElevationRaster& raster, const SampleLocator& locator) {
    double lon_deg = 0.5 * (raster.model.columns - 1), lat_deg = 0.5 * (raster.model.rows - 1);
    locator.locate({&lon_deg, 1}, {&lat_deg, 1});
    if (!std::isfinite(lon_deg) || !std::isfinite(lat_deg))
        throw UserError({raster.file}, fmt::format("its middle has no place on Earth in CRS \"{}\"; state the right "
                                                   "one with crs:",
                                                   raster.crs_name));
    return {Angle::degrees(std::remainder(lon_deg, 360.0)), Angle::degrees(lat_deg), 0.0};
}

}  // namespace

ElevationFile read_elevation(const ElevationSource& source) {
    check(!source.dem.empty(), "read_elevation: at least one file");
    const GdalMessages messages;
    ElevationRaster raster = read_joined(source);
    const SampleLocator locator(raster);
    ElevationFile elevation;
    elevation.centre = centre_of(raster, locator);
    elevation.report = describe(raster, locator);
    elevation.model = std::make_shared<const ElevationModel>(std::move(raster.model));
    elevation.locate = RowLocator(elevation.model, locator, raster);
    return elevation;
}

}  // namespace overfly
