#include "io/elevation_band.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <gdal_priv.h>

#include "core/error.h"
#include "io/gdal_messages.h"

namespace overfly {
namespace {

// Half the width of what is equal to a no-data value. A value that went through text, or from double to float, comes
// back within 2 units in the last place of a float, relative 2^-22; integers must be equal.
double no_data_tolerance(GDALDataType type, double no_data) {
    if (GDALDataTypeIsInteger(type) != 0 || !std::isfinite(no_data)) return 0.0;
    return std::abs(no_data) * 0x1p-22;
}

// What becomes of a sample that was read.
struct SampleRule {
    bool has_no_data = false;
    double no_data = 0.0, tolerance = 0.0;
    double scale = 1.0, offset = 0.0;  // metres = scale * sample + offset

    [[nodiscard]] bool is_measured(double sample) const {
        if (!std::isfinite(sample)) return false;
        return !has_no_data || !(std::abs(sample - no_data) <= tolerance);
    }
    [[nodiscard]] float height_m(double sample) const { return static_cast<float>(scale * sample + offset); }
};

SampleRule sample_rule(GDALRasterBand& band, std::optional<double> no_data, double metres_per_unit) {
    SampleRule rule;
    rule.has_no_data = no_data.has_value();
    if (no_data) {
        rule.no_data = *no_data;
        rule.tolerance = no_data_tolerance(band.GetRasterDataType(), *no_data);
    }
    int has_scale = 0, has_offset = 0;
    const double scale = band.GetScale(&has_scale), offset = band.GetOffset(&has_offset);
    rule.scale = (has_scale != 0 ? scale : 1.0) * metres_per_unit;
    rule.offset = (has_offset != 0 ? offset : 0.0) * metres_per_unit;
    return rule;
}

// Rows are read in strips that are whole blocks of the file and some megabytes large.
int rows_per_strip(GDALRasterBand& band) {
    int block_columns = 1, block_rows = 1;
    band.GetBlockSize(&block_columns, &block_rows);
    constexpr int kSamples = 1 << 20;
    const int wanted = std::max(kSamples / band.GetXSize(), 1);
    return std::min((wanted + block_rows - 1) / block_rows * block_rows, band.GetYSize());
}

}  // namespace

std::optional<double> no_data_of(GDALRasterBand& band, std::optional<double> stated) {
    if (stated) return stated;
    int has_no_data = 0;
    const double no_data = band.GetNoDataValue(&has_no_data);
    return has_no_data != 0 ? std::optional<double>(no_data) : std::nullopt;
}

ElevationModel read_band(GDALRasterBand& band, std::optional<double> no_data, double metres_per_unit,
                         const std::filesystem::path& file) {
    ElevationModel model{band.GetXSize(), band.GetYSize(), {}, {}};
    const auto columns = static_cast<std::size_t>(model.columns);
    model.height_m.resize(columns * static_cast<std::size_t>(model.rows));
    model.is_valid.resize(model.height_m.size());

    const SampleRule rule = sample_rule(band, no_data_of(band, no_data), metres_per_unit);
    // The mask that GDAL makes of a no-data value says nothing new; one that is stored does.
    const bool has_mask = (band.GetMaskFlags() & (GMF_ALL_VALID | GMF_NODATA)) == 0;
    const int strip_rows = rows_per_strip(band);
    std::vector<double> samples(columns * static_cast<std::size_t>(strip_rows));
    std::vector<std::uint8_t> mask(has_mask ? samples.size() : 0);

    const GdalMessages messages;
    for (int row = 0; row < model.rows; row += strip_rows) {
        const int rows = std::min(strip_rows, model.rows - row);
        CPLErr result = band.RasterIO(GF_Read, 0, row, model.columns, rows, samples.data(), model.columns, rows,
                                      GDT_Float64, 0, 0, nullptr);
        if (result == CE_None && has_mask)
            result = band.GetMaskBand()->RasterIO(GF_Read, 0, row, model.columns, rows, mask.data(), model.columns,
                                                  rows, GDT_Byte, 0, 0, nullptr);
        // Some drivers report broken data and go on with zeros, so their words count, not the result alone.
        if (result != CE_None || messages.has_failure())
            throw UserError({file}, "can't be read to the end: " + messages.text());
        const std::size_t first = model.index(0, row), count = columns * static_cast<std::size_t>(rows);
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_valid = rule.is_measured(samples[i]) && (!has_mask || mask[i] != 0);
            model.is_valid[first + i] = is_valid ? 1 : 0;
            model.height_m[first + i] = is_valid ? rule.height_m(samples[i]) : 0.0F;
        }
    }
    return model;
}

}  // namespace overfly
