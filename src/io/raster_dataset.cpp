#include "io/raster_dataset.h"

#include <algorithm>
#include <memory>
#include <string>

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include "core/error.h"
#include "io/gdal_messages.h"

namespace overfly {
namespace {

// Drivers that know the datum of heights keep it to themselves unless asked; the answer holds for this thread and
// scope.
class ReportVerticalDatum {
  public:
    ReportVerticalDatum() {
        CPLSetThreadLocalConfigOption("GTIFF_REPORT_COMPD_CS", "YES");
        CPLSetThreadLocalConfigOption("REPORT_COMPD_CS", "YES");
    }
    ~ReportVerticalDatum() {
        CPLSetThreadLocalConfigOption("GTIFF_REPORT_COMPD_CS", nullptr);
        CPLSetThreadLocalConfigOption("REPORT_COMPD_CS", nullptr);
    }
    ReportVerticalDatum(const ReportVerticalDatum&) = delete;
    ReportVerticalDatum& operator=(const ReportVerticalDatum&) = delete;
};

RasterDataset try_open(const std::string& name, unsigned kind) {
    const ReportVerticalDatum report;
    RasterDataset dataset(GDALDataset::FromHandle(
        GDALOpenEx(name.c_str(), kind | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr, nullptr)));
    // The CRS is found out on first demand and kept, so it is asked for while the option holds.
    if (dataset) dataset->GetSpatialRef();
    return dataset;
}

bool is_zip(const std::filesystem::path& file) { return CPLString(file.extension().string()).tolower() == ".zip"; }

RasterDataset open_in_zip(const std::filesystem::path& file) {
    const std::string root = "/vsizip/" + file.string();
    const CPLStringList names(VSIReadDirRecursive(root.c_str()));
    std::vector<std::string> rasters;
    for (int i = 0; i < names.size(); ++i) {
        const std::string name = root + "/" + names[i];
        if (name.back() != '/' && GDALIdentifyDriverEx(name.c_str(), GDAL_OF_RASTER, nullptr, nullptr) != nullptr)
            rasters.push_back(name);
    }
    if (rasters.empty()) throw UserError({file}, "the archive holds no raster that GDAL opens");
    if (rasters.size() > 1)
        throw UserError({file}, fmt::format("the archive holds {} rasters; unpack it and name them, the first is {}",
                                            rasters.size(), rasters.front().substr(root.size() + 1)));
    const GdalMessages messages;
    RasterDataset dataset = try_open(rasters.front(), GDAL_OF_RASTER);
    if (!dataset) throw UserError({file}, "can't be opened as a raster: " + messages.text());
    return dataset;
}

// "/vsizip/folder/archive.zip/inner.tif" is "folder/archive.zip" on disk.
std::filesystem::path on_disk(const std::string& name) {
    constexpr std::string_view kPrefix = "/vsizip/";
    if (!name.starts_with(kPrefix)) return name;
    std::filesystem::path path = name.substr(kPrefix.size());
    while (path.has_relative_path() && !std::filesystem::is_regular_file(path)) path = path.parent_path();
    return path;
}

}  // namespace

void CloseDataset::operator()(GDALDataset* dataset) const { GDALClose(GDALDataset::ToHandle(dataset)); }

RasterDataset open_raster(const std::filesystem::path& file) {
    const GdalMessages messages;
    VSIStatBufL stat;
    if (VSIStatL(file.c_str(), &stat) != 0) throw UserError({file}, "not found");
    // SRTM tiles are opened under their archive's name, which says where on the Earth they are; hence first as it is.
    if (RasterDataset dataset = try_open(file.string(), GDAL_OF_RASTER)) {
        if (dataset->GetRasterCount() > 0) return dataset;
        const CPLStringList parts(dataset->GetMetadata("SUBDATASETS"), FALSE);
        if (parts.empty()) throw UserError({file}, "holds no raster band");
        throw UserError({file},
                        fmt::format("holds {} rasters; take the one with the heights out of it (gdal_translate)",
                                    parts.size() / 2));
    }
    if (is_zip(file)) return open_in_zip(file);
    const std::string reason = messages.text();
    if (const RasterDataset vector = try_open(file.string(), GDAL_OF_VECTOR))
        throw UserError({file}, fmt::format("holds vector data ({}), not a raster of heights",
                                            vector->GetDriver()->GetDescription()));
    throw UserError({file}, "can't be opened as a raster: " + reason);
}

std::vector<std::filesystem::path> files_of(GDALDataset& dataset) {
    const CPLStringList names(dataset.GetFileList());
    std::vector<std::filesystem::path> files;
    for (int i = 0; i < names.size(); ++i) {
        std::filesystem::path file = on_disk(names[i]);
        if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(std::move(file));
    }
    return files;
}

}  // namespace overfly
