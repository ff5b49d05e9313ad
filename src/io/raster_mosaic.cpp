#include "io/raster_mosaic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include "core/error.h"

namespace overfly {
namespace {

// How far, in samples, a grid may be off the first one's. Tiles carry their corner in text or in seconds of arc, with
// errors around 1e-9 of a sample; a real shift is at least a sample's half.
constexpr double kAlignment_samples = 1e-3;

// Where a raster's first sample lies in the grid of the first raster.
struct Offset {
    long column = 0, row = 0;
};

bool is_same_crs(const ElevationRaster& a, const ElevationRaster& b) {
    if (a.crs_wkt == b.crs_wkt) return true;
    OGRSpatialReference crs_a, crs_b;
    crs_a.importFromWkt(a.crs_wkt.c_str());
    crs_b.importFromWkt(b.crs_wkt.c_str());
    return crs_a.IsSame(&crs_b) != 0;
}

// Offset of `b`'s corner from `a`'s, in samples of `a`.
std::array<double, 2> corner_offset(const CrsFromPixel& a, const CrsFromPixel& b) {
    const double determinant = a[1] * a[5] - a[2] * a[4];
    const double x = b[0] - a[0], y = b[3] - a[3];
    return {(x * a[5] - y * a[2]) / determinant, (y * a[1] - x * a[4]) / determinant};
}

// How much the two grids drift apart over the samples of `b`, in samples.
double spacing_drift(const ElevationRaster& a, const ElevationRaster& b) {
    CrsFromPixel moved = a.crs_from_pixel;
    double drift = 0.0;
    for (const auto& [k, count] : {std::pair{1U, b.model.columns}, std::pair{2U, b.model.rows}}) {
        moved[0] = a.crs_from_pixel[0] + b.crs_from_pixel[k] - a.crs_from_pixel[k];
        moved[3] = a.crs_from_pixel[3] + b.crs_from_pixel[k + 3] - a.crs_from_pixel[k + 3];
        const auto [column, row] = corner_offset(a.crs_from_pixel, moved);
        drift = std::max(drift, std::hypot(column, row) * count);
    }
    return drift;
}

std::string spacing(const ElevationRaster& r) {
    const CrsFromPixel& a = r.crs_from_pixel;
    return fmt::format("{:.10g} x {:.10g} {}", std::hypot(a[1], a[4]), std::hypot(a[2], a[5]), r.crs_unit);
}

// What keeps `b` from being joined with `a`; empty where nothing does.
std::string difference(const ElevationRaster& a, const ElevationRaster& b) {
    const std::string first = a.file.filename().string();
    if (!is_same_crs(a, b)) return fmt::format("has CRS \"{}\", {} has \"{}\"", b.crs_name, first, a.crs_name);
    if (a.vertical.datum != b.vertical.datum || a.vertical.offset_m != b.vertical.offset_m)
        return fmt::format("counts heights from {}, {} from {}", b.vertical.name, first, a.vertical.name);
    if (spacing_drift(a, b) > kAlignment_samples)
        return spacing(a) == spacing(b)
                   ? fmt::format("has its rows or columns in another direction than {}", first)
                   : fmt::format("has a spacing of {}, {} one of {}", spacing(b), first, spacing(a));
    const auto [column, row] = corner_offset(a.crs_from_pixel, b.crs_from_pixel);
    const double off = std::max(std::abs(column - std::round(column)), std::abs(row - std::round(row)));
    if (off > kAlignment_samples)
        return fmt::format("has its samples between those of {}: shifted by {:.3f} columns and {:.3f} rows", first,
                           column - std::round(column), row - std::round(row));
    return {};
}

void paste(const ElevationModel& part, Offset at, ElevationModel& whole) {
    for (int row = 0; row < part.rows; ++row)
        for (int column = 0; column < part.columns; ++column) {
            const std::size_t from = part.index(column, row);
            const std::size_t to = whole.index(column + static_cast<int>(at.column), row + static_cast<int>(at.row));
            if (part.is_valid[from] == 0 || whole.is_valid[to] != 0) continue;
            whole.height_m[to] = part.height_m[from];
            whole.is_valid[to] = 1;
        }
}

// Makes `joined` large enough for all; moves its first sample, and `offsets` with it, to the corner of the whole.
void lay_out(const std::vector<ElevationRaster>& rasters, std::vector<Offset>& offsets, ElevationRaster& joined) {
    Offset low, high;
    for (std::size_t i = 0; i < rasters.size(); ++i) {
        low = {std::min(low.column, offsets[i].column), std::min(low.row, offsets[i].row)};
        high = {std::max(high.column, offsets[i].column + rasters[i].model.columns),
                std::max(high.row, offsets[i].row + rasters[i].model.rows)};
    }
    const auto columns = static_cast<double>(high.column - low.column), rows = static_cast<double>(high.row - low.row);
    if (columns * rows > static_cast<double>(kMostSamples))
        throw UserError({joined.file}, fmt::format("joined with the others makes {:.0f}x{:.0f} samples; at most {} can "
                                                   "be meshed: the files lie too far apart",
                                                   columns, rows, kMostSamples));
    for (Offset& offset : offsets) offset = {offset.column - low.column, offset.row - low.row};
    CrsFromPixel& a = joined.crs_from_pixel;
    const auto column = static_cast<double>(low.column), row = static_cast<double>(low.row);
    a[0] += column * a[1] + row * a[2];
    a[3] += column * a[4] + row * a[5];
    joined.model = {static_cast<int>(high.column - low.column), static_cast<int>(high.row - low.row), {}, {}};
    joined.model.height_m.assign(static_cast<std::size_t>(columns * rows), 0.0F);
    joined.model.is_valid.assign(joined.model.height_m.size(), 0);
}

}  // namespace

ElevationRaster join_rasters(std::vector<ElevationRaster> rasters) {
    check(!rasters.empty(), "join_rasters: at least one raster");
    if (rasters.size() == 1) return std::move(rasters.front());

    std::vector<Problem> problems;
    std::vector<Offset> offsets;
    for (const ElevationRaster& raster : rasters) {
        if (const std::string how = difference(rasters.front(), raster); !how.empty())
            problems.push_back({{raster.file}, how + "; bring them onto one grid first (gdalwarp)"});
        const auto [column, row] = corner_offset(rasters.front().crs_from_pixel, raster.crs_from_pixel);
        offsets.push_back({std::lround(column), std::lround(row)});
    }
    if (!problems.empty()) throw UserError(std::move(problems));

    ElevationRaster joined = rasters.front();
    lay_out(rasters, offsets, joined);
    for (std::size_t i = 0; i < rasters.size(); ++i) {
        paste(rasters[i].model, offsets[i], joined.model);
        // What is assumed of one part is assumed of the whole.
        joined.vertical.provenance = std::max(joined.vertical.provenance, rasters[i].vertical.provenance);
        joined.unit_provenance = std::max(joined.unit_provenance, rasters[i].unit_provenance);
        for (const std::filesystem::path& file : rasters[i].files)
            if (std::ranges::find(joined.files, file) == joined.files.end()) joined.files.push_back(file);
    }
    return joined;
}

}  // namespace overfly
