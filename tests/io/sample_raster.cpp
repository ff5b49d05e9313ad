#include "io/sample_raster.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

namespace overfly {
namespace {

GDALDatasetH open(const std::filesystem::path& file) {
    GDALAllRegister();
    GDALDatasetH dataset = GDALOpen(file.c_str(), GA_ReadOnly);
    EXPECT_NE(dataset, nullptr) << file;
    return dataset;
}

OGRSpatialReference crs_named(const std::string& name) {
    OGRSpatialReference crs;
    EXPECT_EQ(crs.SetFromUserInput(name.c_str()), OGRERR_NONE) << name;
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return crs;
}

void set_up_band(GDALRasterBand& band, const SampleRaster& raster) {
    if (raster.no_data) band.SetNoDataValue(*raster.no_data);
    if (!raster.unit.empty()) band.SetUnitType(raster.unit.c_str());
    if (raster.scale) band.SetScale(*raster.scale);
    if (raster.offset) band.SetOffset(*raster.offset);
    if (raster.has_palette) {
        GDALColorTable colours;
        const GDALColorEntry red{255, 0, 0, 255};
        colours.SetColorEntry(1, &red);
        band.SetColorTable(&colours);
    }
}

}  // namespace

std::filesystem::path blanca() {
    return std::filesystem::path(OVERFLY_SOURCE_DIR) / "terrain" / "blanca_peak_utm13n_75m.tif";
}

void translate(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& options) {
    GDALDatasetH source = open(from);
    CPLStringList words(CSLTokenizeString(options.c_str()));
    GDALTranslateOptions* parsed = GDALTranslateOptionsNew(words.List(), nullptr);
    GDALDatasetH made = GDALTranslate(to.c_str(), source, parsed, nullptr);
    EXPECT_NE(made, nullptr) << to << ": " << CPLGetLastErrorMsg();
    GDALTranslateOptionsFree(parsed);
    GDALClose(made);
    GDALClose(source);
}

void warp(const std::filesystem::path& from, const std::filesystem::path& to, const std::string& options) {
    GDALDatasetH source = open(from);
    CPLStringList words(CSLTokenizeString(options.c_str()));
    GDALWarpAppOptions* parsed = GDALWarpAppOptionsNew(words.List(), nullptr);
    GDALDatasetH made = GDALWarp(to.c_str(), nullptr, 1, &source, parsed, nullptr);
    EXPECT_NE(made, nullptr) << to << ": " << CPLGetLastErrorMsg();
    GDALWarpAppOptionsFree(parsed);
    GDALClose(made);
    GDALClose(source);
}

void zip(const std::filesystem::path& file, const std::filesystem::path& archive) {
    const std::string inside = "/vsizip/" + (archive / file.filename()).string();
    VSILFILE* from = VSIFOpenL(file.c_str(), "rb");
    VSILFILE* to = VSIFOpenL(inside.c_str(), "wb");
    ASSERT_TRUE(from != nullptr && to != nullptr) << archive;
    std::vector<char> bytes(std::filesystem::file_size(file));
    ASSERT_EQ(VSIFReadL(bytes.data(), 1, bytes.size(), from), bytes.size());
    ASSERT_EQ(VSIFWriteL(bytes.data(), 1, bytes.size(), to), bytes.size());
    VSIFCloseL(to);
    VSIFCloseL(from);
}

void write_raster(const std::filesystem::path& file, const SampleRaster& raster) {
    GDALAllRegister();
    GDALDataset* const dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        file.c_str(), raster.columns, raster.rows, raster.bands, GDALGetDataTypeByName(raster.type.c_str()), nullptr);
    ASSERT_NE(dataset, nullptr);
    auto a = raster.crs_from_pixel;
    if (a) dataset->SetGeoTransform(a->data());
    if (!raster.crs.empty()) {
        const OGRSpatialReference crs = crs_named(raster.crs);
        dataset->SetSpatialRef(&crs);
    }
    GDALRasterBand& band = *dataset->GetRasterBand(1);
    set_up_band(band, raster);
    std::vector<double> values = raster.values;
    values.resize(static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows));
    EXPECT_EQ(band.RasterIO(GF_Write, 0, 0, raster.columns, raster.rows, values.data(), raster.columns, raster.rows,
                            GDT_Float64, 0, 0, nullptr),
              CE_None);
    if (!raster.mask.empty()) {
        EXPECT_EQ(dataset->CreateMaskBand(GMF_PER_DATASET), CE_None);
        std::vector<std::uint8_t> mask = raster.mask;
        EXPECT_EQ(band.GetMaskBand()->RasterIO(GF_Write, 0, 0, raster.columns, raster.rows, mask.data(), raster.columns,
                                               raster.rows, GDT_Byte, 0, 0, nullptr),
                  CE_None);
    }
    GDALClose(dataset);
}

Proj::Proj(const std::string& pipeline) {
    OGRCoordinateTransformationOptions options;
    options.SetCoordinateOperation(pipeline.c_str(), false);
    transformation_ = OGRCreateCoordinateTransformation(nullptr, nullptr, options);
    EXPECT_NE(transformation_, nullptr) << pipeline;
}

Proj::Proj(const std::string& from, const std::string& to) {
    const OGRSpatialReference a = crs_named(from), b = crs_named(to);
    transformation_ = OGRCreateCoordinateTransformation(&a, &b);
    EXPECT_NE(transformation_, nullptr) << from << " to " << to;
}

Proj::~Proj() { delete static_cast<OGRCoordinateTransformation*>(transformation_); }

std::array<double, 3> Proj::operator()(std::array<double, 3> p) const {
    EXPECT_TRUE(static_cast<OGRCoordinateTransformation*>(transformation_)->Transform(1, &p[0], &p[1], &p[2]));
    return p;
}

}  // namespace overfly
