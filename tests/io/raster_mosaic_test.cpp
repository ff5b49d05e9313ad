#include "io/raster_mosaic.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/elevation_file.h"
#include "io/sample_raster.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(RasterMosaic, TilesMakeTheWholeAgain) {
    const TemporaryFolder folder;
    // Overlapping by a column and a row, as tiles of the shuttle mission do; with different types, and one in feet.
    translate(blanca(), folder / "nw.tif", "-srcwin 0 0 350 301");
    translate(blanca(), folder / "ne.tif", "-srcwin 349 0 345 301 -ot Float32");
    translate(blanca(), folder / "sw.tif", "-srcwin 0 300 350 380 -ot Int32");
    translate(blanca(), folder / "se.asc", "-srcwin 349 300 345 380 -of AAIGrid");
    const ElevationFile whole = read_elevation({.dem = {blanca()}});
    const ElevationFile joined =
        read_elevation({.dem = {folder / "se.asc", folder / "nw.tif", folder / "sw.tif", folder / "ne.tif"}});
    EXPECT_EQ(joined.model->columns, 694);
    EXPECT_EQ(joined.model->rows, 680);
    EXPECT_EQ(joined.model->height_m, whole.model->height_m);
    EXPECT_EQ(joined.model->is_valid, whole.model->is_valid);
    EXPECT_EQ(joined.report.extent.west_deg, whole.report.extent.west_deg);
    EXPECT_GE(joined.report.files.size(), 4U);
}

TEST(RasterMosaic, GapsAreVoidsAndVoidsAreFilledByTheNextFile) {
    const TemporaryFolder folder;
    SampleRaster a, b;
    a.no_data = b.no_data = -1;
    a.values = {10, 11, -1, 13, 14, 15};
    b.values = {20, 21, 22, 23, 24, -1};
    b.crs_from_pixel = {{470'000 + 60, 30, 0, 4'180'000 - 30, 0, -30}};  // two columns east, one row south
    write_raster(folder / "a.tif", a);
    write_raster(folder / "b.tif", b);
    const ElevationFile joined = read_elevation({.dem = {folder / "a.tif", folder / "b.tif"}});
    EXPECT_EQ(joined.model->columns, 5);
    EXPECT_EQ(joined.model->rows, 3);
    EXPECT_EQ(joined.model->height_m, (std::vector<float>{10, 11, 0, 0, 0, 13, 14, 15, 21, 22, 0, 0, 23, 24, 0}));
    EXPECT_EQ(joined.model->is_valid, (std::vector<std::uint8_t>{1, 1, 0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 1, 1, 0}));
    EXPECT_NEAR(joined.report.no_data_share, 6.0 / 15.0, 1e-12);

    // The other order: b's corner is not the whole's, and b wins where both measured.
    const ElevationFile reversed = read_elevation({.dem = {folder / "b.tif", folder / "a.tif"}});
    EXPECT_EQ(reversed.model->is_valid, joined.model->is_valid);
    EXPECT_EQ(reversed.model->height_m[7], 20.0F);
    EXPECT_EQ(reversed.report.extent, joined.report.extent);
}

std::string refusal(const SampleRaster& b, const SampleRaster& a = {}) {
    const TemporaryFolder folder;
    write_raster(folder / "a.tif", a);
    write_raster(folder / "b.tif", b);
    try {
        (void)read_elevation({.dem = {folder / "a.tif", folder / "b.tif"}});
    } catch (const UserError& error) {
        EXPECT_EQ(error.problems().size(), 1U);
        return error.what();
    }
    return "(they were joined)";
}

TEST(RasterMosaic, SaysWhichFileDiffersAndHow) {
    SampleRaster b;
    EXPECT_EQ(refusal(b), "(they were joined)");
    b.crs = "EPSG:32612";
    EXPECT_THAT(refusal(b), HasSubstr("b.tif: has CRS \"WGS 84 / UTM zone 12N\", a.tif has \"WGS 84 / UTM zone 13N\""));
    b = {};
    b.crs_from_pixel = {{470'000, 31, 0, 4'180'000, 0, -30}};
    EXPECT_THAT(refusal(b), HasSubstr("has a spacing of 31 x 30 metre, a.tif one of 30 x 30 metre"));
    b.crs_from_pixel = {{470'000, 30, 0, 4'180'000 - 60, 0, 30}};
    EXPECT_THAT(refusal(b), HasSubstr("has its rows or columns in another direction than a.tif"));
    b.crs_from_pixel = {{470'090 + 15, 30, 0, 4'180'000 - 3, 0, -30}};
    EXPECT_THAT(refusal(b), AllOf(HasSubstr("has its samples between those of a.tif"), HasSubstr("0.100 rows")));
    b.crs_from_pixel = {{470'000 + 30e6, 30, 0, 4'180'000 + 30e6, 0, -30}};
    EXPECT_THAT(refusal({}, b), HasSubstr("lie too far apart"));
}

TEST(RasterMosaic, DatumsMustBeTheSameButNotHowTheyAreKnown) {
    SampleRaster a, b;
    a.crs_from_pixel = b.crs_from_pixel = {{-105, 0.001, 0, 38, 0, -0.001}};
    a.crs = "EPSG:4326";
    b.crs = "EPSG:4979";
    EXPECT_THAT(refusal(b, a), HasSubstr("counts heights from ellipsoid, a.tif from EGM96 geoid"));

    const TemporaryFolder folder;
    b.crs = "EPSG:4326+5773";
    write_raster(folder / "a.tif", a);
    write_raster(folder / "b.tif", b);
    const ElevationFile joined = read_elevation({.dem = {folder / "b.tif", folder / "a.tif"}});
    EXPECT_EQ(joined.report.vertical.provenance, Provenance::Assumed);
}

TEST(RasterMosaic, UnitsAreEachFilesOwn) {
    const TemporaryFolder folder;
    SampleRaster a, b;
    a.values.assign(6, 1000);
    b.values.assign(6, 1);
    b.unit = "km";
    b.crs_from_pixel = {{470'090, 30, 0, 4'180'000, 0, -30}};
    write_raster(folder / "a.tif", a);
    write_raster(folder / "b.tif", b);
    const ElevationFile joined = read_elevation({.dem = {folder / "a.tif", folder / "b.tif"}});
    EXPECT_EQ(joined.model->height_m, std::vector<float>(12, 1000.0F));
}

}  // namespace
}  // namespace overfly
