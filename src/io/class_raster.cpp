#include "io/class_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "core/error.h"
#include "core/parallel.h"
#include "io/gdal_messages.h"
#include "io/raster_dataset.h"

namespace overfly {
namespace {

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;
using GeoTransform = std::array<double, 6>;

// Places that one task takes through PROJ.
constexpr std::size_t kPlacesAtOnce = 1 << 18;
// Pixels that are in memory at once.
constexpr std::int64_t kPixelsAtOnce = 1 << 22;

struct Pixel {
    std::int32_t column = -1, row = -1;  // -1: outside
};

// A rectangle of pixels, ends included; empty where a first is after its last.
struct Window {
    int first_column = std::numeric_limits<int>::max(), last_column = -1;
    int first_row = std::numeric_limits<int>::max(), last_row = -1;

    void add(Pixel p) {
        if (p.row < 0) return;
        first_column = std::min(first_column, p.column);
        last_column = std::max(last_column, p.column);
        first_row = std::min(first_row, p.row);
        last_row = std::max(last_row, p.row);
    }
    [[nodiscard]] bool empty() const { return last_row < 0; }
    [[nodiscard]] int columns() const { return last_column - first_column + 1; }
};

// From longitude and latitude to the pixels of a raster. For one thread.
class PixelLocator {
  public:
    PixelLocator(GDALDataset& dataset, const std::filesystem::path& file)
        : columns_(dataset.GetRasterXSize()), rows_(dataset.GetRasterYSize()) {
        GeoTransform crs_from_pixel{};
        if (dataset.GetGeoTransform(crs_from_pixel.data()) != CE_None ||
            GDALInvGeoTransform(crs_from_pixel.data(), pixel_from_crs_.data()) == 0)
            throw UserError({file}, "does not say where it lies (no geotransform, no world file)");
        const OGRSpatialReference* const own = dataset.GetSpatialRef();
        if (own == nullptr || (own->IsGeographic() == 0 && own->IsProjected() == 0))
            throw UserError({file}, "has no coordinate reference system; give it one with gdal_edit or gdalwarp");
        OGRSpatialReference to = *own, from;
        from.importFromEPSG(4326);
        from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        if (to.IsCompound() != 0) to.StripVertical();
        if (to.IsGeographic() != 0) {
            turn_ = 2.0 * Angle::degrees(180.0).radians() / to.GetAngularUnits();
            // A raster's longitudes may be any turn of ours: counted from its own middle.
            middle_ = crs_from_pixel[0] + 0.5 * (columns_ * crs_from_pixel[1] + rows_ * crs_from_pixel[2]);
            if (to.IsSame(&from) != 0) return;
        }
        // A "ballpark" transformation ignores the datum, which may be hundreds of metres: refused, not guessed.
        OGRCoordinateTransformationOptions options;
        options.SetBallparkAllowed(false);
        from_wgs84_.reset(OGRCreateCoordinateTransformation(&from, &to, options));
        if (!from_wgs84_) throw UserError({file}, "no transformation from WGS84 to its CRS is known");
    }
    PixelLocator(const PixelLocator& other)
        : pixel_from_crs_(other.pixel_from_crs_),
          columns_(other.columns_),
          rows_(other.rows_),
          turn_(other.turn_),
          middle_(other.middle_),
          from_wgs84_(other.from_wgs84_ ? other.from_wgs84_->Clone() : nullptr) {}
    PixelLocator& operator=(const PixelLocator&) = delete;
    ~PixelLocator() = default;

    // REQUIRES: as many pixels as places, at most kPlacesAtOnce.
    void locate(std::span<const Geodetic> places, std::span<Pixel> pixels) {
        x_.resize(places.size());
        y_.resize(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            x_[i] = std::remainder(places[i].lon.degrees(), 360.0);
            y_[i] = places[i].lat.degrees();
        }
        // Says that it failed where a single place has no coordinates there; that one is infinite then.
        if (from_wgs84_) from_wgs84_->Transform(static_cast<int>(x_.size()), x_.data(), y_.data());
        for (std::size_t i = 0; i < places.size(); ++i) pixels[i] = pixel_at(x_[i], y_[i]);
    }

  private:
    [[nodiscard]] Pixel pixel_at(double x, double y) const {
        if (!std::isfinite(x) || !std::isfinite(y)) return {};
        if (turn_ > 0.0) x = middle_ + std::remainder(x - middle_, turn_);
        const GeoTransform& a = pixel_from_crs_;
        const double column = std::floor(a[0] + x * a[1] + y * a[2]), row = std::floor(a[3] + x * a[4] + y * a[5]);
        const bool is_inside = column >= 0.0 && row >= 0.0 && column < columns_ && row < rows_;
        return is_inside ? Pixel{static_cast<std::int32_t>(column), static_cast<std::int32_t>(row)} : Pixel{};
    }

    GeoTransform pixel_from_crs_{};
    int columns_, rows_;
    double turn_ = 0.0, middle_ = 0.0;  // of a geographic CRS, in its own unit; 0: it is projected
    Transformation from_wgs84_;         // none: the CRS is longitude and latitude on WGS84 itself
    std::vector<double> x_, y_;
};

std::vector<Pixel> located(const PixelLocator& locator, std::span<const Geodetic> places) {
    std::vector<Pixel> pixels(places.size());
    std::mutex mutex;
    parallel_for((places.size() + kPlacesAtOnce - 1) / kPlacesAtOnce, [&](std::size_t task) {
        const GdalMessages messages;
        const std::size_t first = task * kPlacesAtOnce, count = std::min(kPlacesAtOnce, places.size() - first);
        // PROJ's objects serve one thread at a time; to copy one is as nothing beside so many places.
        std::optional<PixelLocator> own;
        {
            const std::scoped_lock lock(mutex);
            own.emplace(locator);
        }
        own->locate(places.subspan(first, count), std::span(pixels).subspan(first, count));
    });
    return pixels;
}

int class_of(double value, const std::filesystem::path& file) {
    if (!(value >= 0.0) || value > std::numeric_limits<int>::max()) return kNoClass;
    if (value != std::trunc(value)) throw UserError({file}, fmt::format("holds {}: classes are whole numbers", value));
    return static_cast<int>(value);
}

// Strips of the window that are whole blocks of the file, so that none is decoded twice.
int rows_per_strip(GDALRasterBand& band, const Window& window) {
    int block_columns = 1, block_rows = 1;
    band.GetBlockSize(&block_columns, &block_rows);
    const auto wanted = static_cast<int>(std::max<std::int64_t>(kPixelsAtOnce / window.columns(), 1));
    return std::max(wanted / block_rows, 1) * block_rows;
}

struct Strip {
    std::vector<double> values;
    std::vector<std::uint8_t> mask;  // 0: no data

    void read(GDALRasterBand& band, const Window& window, int row, int rows, const std::filesystem::path& file) {
        const GdalMessages messages;
        const int columns = window.columns();
        values.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
        mask.resize(values.size());
        CPLErr result = band.RasterIO(GF_Read, window.first_column, row, columns, rows, values.data(), columns, rows,
                                      GDT_Float64, 0, 0, nullptr);
        if (result == CE_None)
            result = band.GetMaskBand()->RasterIO(GF_Read, window.first_column, row, columns, rows, mask.data(),
                                                  columns, rows, GDT_Byte, 0, 0, nullptr);
        // Some drivers report broken data and go on with zeros, so their words count, not the result alone.
        if (result != CE_None || messages.has_failure())
            throw UserError({file}, "can't be read to the end: " + messages.text());
    }
};

}  // namespace

std::vector<std::filesystem::path> class_raster_inputs(const std::filesystem::path& file) {
    return files_of(*open_raster(file));
}

std::vector<int> classes_at(const std::filesystem::path& file, int band_number, std::span<const Geodetic> places) {
    const GdalMessages messages;
    const RasterDataset dataset = open_raster(file);
    if (band_number < 1 || band_number > dataset->GetRasterCount())
        throw UserError({file}, fmt::format("classes.band: {} is stated, the file has {} band(s)", band_number,
                                            dataset->GetRasterCount()));
    GDALRasterBand& band = *dataset->GetRasterBand(band_number);
    const std::vector<Pixel> pixels = located(PixelLocator(*dataset, file), places);
    Window window;
    for (const Pixel p : pixels) window.add(p);

    std::vector<int> classes(places.size(), kNoClass);
    if (window.empty()) return classes;
    const int strip_rows = rows_per_strip(band, window);
    Strip strip;
    for (int row = window.first_row / strip_rows * strip_rows; row <= window.last_row; row += strip_rows) {
        const int first = std::max(row, window.first_row), end = std::min(row + strip_rows, window.last_row + 1);
        strip.read(band, window, first, end - first, file);
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            if (pixels[i].row < first || pixels[i].row >= end) continue;
            const std::size_t at =
                static_cast<std::size_t>(pixels[i].row - first) * static_cast<std::size_t>(window.columns()) +
                static_cast<std::size_t>(pixels[i].column - window.first_column);
            if (strip.mask[at] != 0) classes[i] = class_of(strip.values[at], file);
        }
    }
    return classes;
}

}  // namespace overfly
