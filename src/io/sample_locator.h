#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "geo/frames.h"
#include "io/elevation_raster.h"

namespace overfly {

// A rectangle of longitudes and latitudes. east_deg may pass 180 (and then west_deg is below it), so that
// west_deg <= east_deg also across the antimeridian; a raster around a pole has all longitudes, -180 to 180.
struct GeographicExtent {
    double west_deg = 0.0, south_deg = 0.0, east_deg = 0.0, north_deg = 0.0;

    friend bool operator==(const GeographicExtent&, const GeographicExtent&) = default;
};

// Where the samples of a raster are on the WGS84 ellipsoid. May be used by many threads at once; copies share state.
class SampleLocator {
  public:
    // Throws UserError that names the raster's file where no transformation from its CRS to WGS84 is known.
    explicit SampleLocator(const ElevationRaster& raster);

    // In: columns and rows of sample centres (0 is the first). Out: longitudes and latitudes in degrees, not finite
    // where the CRS has none. REQUIRES: both of one size.
    void locate(std::span<double> lon_deg_from_column, std::span<double> lat_deg_from_row) const;

    // Of all sample centres, from those on the raster's border.
    [[nodiscard]] GeographicExtent extent() const;

  private:
    class Projection;
    std::shared_ptr<Projection> projection_;  // none: the CRS is longitude and latitude on WGS84 itself
    CrsFromPixel crs_from_pixel_;
    int columns_, rows_;
};

}  // namespace overfly
