#pragma once

#include <filesystem>
#include <memory>
#include <vector>

class GDALDataset;

namespace overfly {

struct CloseDataset {
    void operator()(GDALDataset* dataset) const;
};
using RasterDataset = std::unique_ptr<GDALDataset, CloseDataset>;

// Opens a raster for reading: anything that GDAL opens, or a .zip that holds one such raster (read in place).
// Throws UserError: not found; not a raster, in GDAL's own words; vector data; no raster or several in the archive.
[[nodiscard]] RasterDataset open_raster(const std::filesystem::path& file);

// All files on disk that GDAL reads for it (side files, the parts of a VRT; an archive counts, not what is in it).
[[nodiscard]] std::vector<std::filesystem::path> files_of(GDALDataset& dataset);

}  // namespace overfly
