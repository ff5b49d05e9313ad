#include "io/class_raster.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/sample_raster.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

Geodetic place(double lon_deg, double lat_deg) { return {Angle::degrees(lon_deg), Angle::degrees(lat_deg), 0.0}; }

std::string refusal(const std::filesystem::path& file, int band = 1) {
    try {
        (void)classes_at(file, band, std::vector{place(-105.5, 37.5)});
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

// Columns 0, 1, 2 ... and rows of tens, 1 degree each, from 10 E and 50 N.
SampleRaster degrees() {
    SampleRaster raster;
    raster.type = "Byte";
    raster.columns = 3;
    raster.rows = 2;
    raster.values = {0, 1, 2, 10, 11, 12};
    raster.crs = "EPSG:4326";
    raster.crs_from_pixel = {{10, 1, 0, 50, 0, -1}};
    return raster;
}

TEST(ClassRaster, SaysWhatThePixelHoldsThatAPlaceIsIn) {
    const TemporaryFolder folder;
    write_raster(folder / "classes.tif", degrees());
    const std::vector<Geodetic> places = {place(10.01, 49.99), place(10.99, 49.01), place(12.5, 48.5),
                                          place(371.5, 49.5),  place(9.99, 49.5),   place(10.5, 50.01),
                                          place(13.01, 49.5),  place(10.5, 47.99)};
    EXPECT_EQ(classes_at(folder / "classes.tif", 1, places),
              (std::vector{0, 0, 12, 1, kNoClass, kNoClass, kNoClass, kNoClass}));
    EXPECT_EQ(classes_at(folder / "classes.tif", 1, {}), std::vector<int>());
}

TEST(ClassRaster, KnowsLongitudesOfOtherTurns) {
    const TemporaryFolder folder;
    SampleRaster raster = degrees();
    raster.crs_from_pixel = {{358.5, 1, 0, 50, 0, -1}};  // 1.5 W to 1.5 E
    write_raster(folder / "classes.tif", raster);
    const std::vector<Geodetic> places = {place(-1.0, 49.5), place(0.0, 49.5), place(1.0, 49.5), place(1.6, 49.5)};
    EXPECT_EQ(classes_at(folder / "classes.tif", 1, places), (std::vector{0, 1, 2, kNoClass}));
}

TEST(ClassRaster, HasNoClassWithoutDataAndBelowZero) {
    const TemporaryFolder folder;
    SampleRaster raster = degrees();
    raster.type = "Int16";
    raster.values = {-5, 1, 2, 10, 11, 12};
    raster.no_data = 11;
    write_raster(folder / "classes.tif", raster);
    const std::vector<Geodetic> places = {place(10.5, 49.5), place(11.5, 49.5), place(11.5, 48.5)};
    EXPECT_EQ(classes_at(folder / "classes.tif", 1, places), (std::vector{kNoClass, 1, kNoClass}));
}

// Another CRS of the same numbers: where all pixels around a place agree, its class is the same through either.
TEST(ClassRaster, SaysTheSameInAnotherCrs) {
    const TemporaryFolder folder;
    translate(blanca(), folder / "utm.tif", "-ot Int16 -scale 0 5000 0 5 -co TILED=YES");
    warp(folder / "utm.tif", folder / "albers.tif", "-t_srs EPSG:5070 -r near -tr 15 15 -dstnodata -1");
    std::mt19937 random(2026);
    std::uniform_real_distribution<double> lon_deg(-105.56, -105.44), lat_deg(37.54, 37.62);
    std::vector<Geodetic> places;
    for (int i = 0; i < 200'000; ++i) places.push_back(place(lon_deg(random), lat_deg(random)));
    const std::vector<int> utm = classes_at(folder / "utm.tif", 1, places);
    const std::vector<int> albers = classes_at(folder / "albers.tif", 1, places);
    std::size_t same = 0;
    for (std::size_t i = 0; i < places.size(); ++i) same += utm[i] == albers[i] ? 1 : 0;
    EXPECT_GT(static_cast<double>(same), 0.99 * static_cast<double>(places.size()));
    EXPECT_GT(*std::ranges::max_element(utm), *std::ranges::min_element(utm));
    EXPECT_GE(*std::ranges::min_element(utm), 0);
}

TEST(ClassRaster, IsRefusedWhereItSaysNoClasses) {
    const TemporaryFolder folder;
    EXPECT_THAT(refusal(folder / "no.tif"), EndsWith("no.tif: not found"));
    SampleRaster raster = degrees();
    raster.crs_from_pixel = {{-106, 1, 0, 38, 0, -1}};
    write_raster(folder / "a.tif", raster);
    EXPECT_EQ(refusal(folder / "a.tif"), "");
    EXPECT_THAT(refusal(folder / "a.tif", 2), EndsWith("classes.band: 2 is stated, the file has 1 band(s)"));
    raster.type = "Float32";
    raster.values[0] = 0.5;
    write_raster(folder / "b.tif", raster);
    EXPECT_THAT(refusal(folder / "b.tif"), EndsWith("b.tif: holds 0.5: classes are whole numbers"));
    raster.crs.clear();
    write_raster(folder / "c.tif", raster);
    EXPECT_THAT(refusal(folder / "c.tif"), HasSubstr("has no coordinate reference system"));
}

TEST(ClassRaster, TellsItsFiles) {
    const TemporaryFolder folder;
    write_raster(folder / "a.tif", degrees());
    translate(folder / "a.tif", folder / "a.vrt", "-of VRT");
    EXPECT_THAT(class_raster_inputs(folder / "a.vrt"),
                testing::UnorderedElementsAre(folder / "a.vrt", folder / "a.tif"));
}

}  // namespace
}  // namespace overfly
