#include "io/sample_locator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <vector>

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include "core/error.h"
#include "io/gdal_messages.h"

namespace overfly {
namespace {

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

OGRSpatialReference wgs84() {
    OGRSpatialReference crs;
    crs.importFromEPSG(4326);
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return crs;
}

OGRSpatialReference crs_of(const ElevationRaster& raster) {
    OGRSpatialReference crs;
    crs.importFromWkt(raster.crs_wkt.c_str());
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return crs;
}

// Same place modulo whole turns, the one nearest to `near_deg`.
double unwrapped(double lon_deg, double near_deg) { return near_deg + std::remainder(lon_deg - near_deg, 360.0); }

// Sample centres along the four sides of a grid, in a ring.
void outline(int columns, int rows, std::vector<double>& x, std::vector<double>& y) {
    constexpr int kSteps = 64;  // a side; sides bend little between
    const std::array<std::array<double, 2>, 5> corners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
    for (std::size_t side = 0; side < 4; ++side)
        for (int i = 0; i < kSteps; ++i) {
            const double t = static_cast<double>(i) / kSteps;
            x.push_back(((1.0 - t) * corners[side][0] + t * corners[side + 1][0]) * (columns - 1));
            y.push_back(((1.0 - t) * corners[side][1] + t * corners[side + 1][1]) * (rows - 1));
        }
}

}  // namespace

// PROJ's transformation objects serve one thread at a time: each caller borrows one, and they are made as needed.
class SampleLocator::Projection {
  public:
    explicit Projection(Transformation first) { idle_.push_back(std::move(first)); }

    void run(std::span<double> x, std::span<double> y) {
        const GdalMessages messages;
        Transformation transformation = take();
        transformation->Transform(static_cast<int>(x.size()), x.data(), y.data());
        const std::scoped_lock lock(mutex_);
        idle_.push_back(std::move(transformation));
    }

  private:
    Transformation take() {
        const std::scoped_lock lock(mutex_);
        // The last one is kept to be copied, so that there always is one.
        if (idle_.size() == 1) return Transformation(idle_.front()->Clone());
        Transformation taken = std::move(idle_.back());
        idle_.pop_back();
        return taken;
    }

    std::mutex mutex_;
    std::vector<Transformation> idle_;
};

SampleLocator::SampleLocator(const ElevationRaster& raster)
    : crs_from_pixel_(raster.crs_from_pixel), columns_(raster.model.columns), rows_(raster.model.rows) {
    const GdalMessages messages;
    const OGRSpatialReference from = crs_of(raster), to = wgs84();
    if (from.IsGeographic() != 0 && from.IsSame(&to) != 0) return;

    // A "ballpark" transformation ignores the datum, which may be hundreds of metres: refused, not guessed.
    OGRCoordinateTransformationOptions options;
    options.SetBallparkAllowed(false);
    const auto make = [&]() -> Transformation {
        Transformation made(OGRCreateCoordinateTransformation(&from, &to, options));
        if (made) return made;
        throw UserError({raster.file}, fmt::format("no transformation from its CRS \"{}\" to WGS84 is known; state the "
                                                   "right one with crs:",
                                                   raster.crs_name));
    };
    projection_ = std::make_shared<Projection>(make());
    // Between datums there may be several transformations, each for some region. Telling the region makes PROJ rank
    // them for this raster.
    const GeographicExtent region = extent();
    const auto turn = [](double lon_deg) { return std::remainder(lon_deg, 360.0); };
    if (std::isfinite(region.west_deg) &&
        options.SetAreaOfInterest(turn(region.west_deg), region.south_deg, turn(region.east_deg), region.north_deg))
        projection_ = std::make_shared<Projection>(make());
}

void SampleLocator::locate(std::span<double> lon_deg_from_column, std::span<double> lat_deg_from_row) const {
    check(lon_deg_from_column.size() == lat_deg_from_row.size(), "SampleLocator: as many columns as rows");
    const CrsFromPixel& a = crs_from_pixel_;
    for (std::size_t i = 0; i < lon_deg_from_column.size(); ++i) {
        const double column = lon_deg_from_column[i] + 0.5, row = lat_deg_from_row[i] + 0.5;
        lon_deg_from_column[i] = a[0] + column * a[1] + row * a[2];
        lat_deg_from_row[i] = a[3] + column * a[4] + row * a[5];
    }
    if (projection_) return projection_->run(lon_deg_from_column, lat_deg_from_row);
    // A grid with a row at the pole may be past it by a rounding error, not by more.
    constexpr double kRounding_deg = 1e-9;
    for (double& lat_deg : lat_deg_from_row)
        if (std::abs(lat_deg) > 90.0)
            lat_deg = std::abs(lat_deg) <= 90.0 + kRounding_deg ? std::copysign(90.0, lat_deg)
                                                                : std::numeric_limits<double>::infinity();
}

GeographicExtent SampleLocator::extent() const {
    std::vector<double> lon_deg, lat_deg;
    outline(columns_, rows_, lon_deg, lat_deg);
    locate(lon_deg, lat_deg);

    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    GeographicExtent e{kInfinity, kInfinity, -kInfinity, -kInfinity};
    double first_deg = kInfinity, last_deg = kInfinity;
    for (std::size_t i = 0; i < lon_deg.size(); ++i) {
        if (!std::isfinite(lon_deg[i]) || !std::isfinite(lat_deg[i])) continue;
        if (std::isinf(first_deg)) first_deg = last_deg = lon_deg[i];
        last_deg = unwrapped(lon_deg[i], last_deg);
        e.west_deg = std::min(e.west_deg, last_deg);
        e.east_deg = std::max(e.east_deg, last_deg);
        e.south_deg = std::min(e.south_deg, lat_deg[i]);
        e.north_deg = std::max(e.north_deg, lat_deg[i]);
    }
    // An outline that does not come back to its own longitude went round a pole.
    if (std::isfinite(first_deg) && std::abs(unwrapped(first_deg, last_deg) - first_deg) > 180.0) {
        const bool is_north = e.north_deg + e.south_deg > 0.0;
        return {-180.0, is_north ? e.south_deg : -90.0, 180.0, is_north ? 90.0 : e.north_deg};
    }
    return e;
}

}  // namespace overfly
