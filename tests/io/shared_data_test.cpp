// Every elevation file of the shared collection is read, with the numbers of its README. This suite is built always and
// run where OVERFLY_SHARED_DATA names the collection; a file that is not there is a failure.

#include <filesystem>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/elevation_file.h"
#include "terrain/triangulate.h"

namespace overfly {
namespace {

constexpr double kFoot_m = 0.3048;

struct Expected {
    std::string file, driver;
    int columns, rows;
    std::size_t void_count;
    double lowest_m, highest_m, tolerance_m;
    std::string crs = {};  // stated where the file has none
};

const std::vector<Expected> kFiles = {
    {"bigtujunga_srtm30m_utm11n.tif", "GTiff", 1197, 643, 0, 315, 2295, 0},
    {"sthelens_usgs30m_nad27utm10.dem", "USGSDEM", 327, 468, 4151, 682, 2543, 0},
    {"zion_srtm90m_wgs84.tif", "GTiff", 465, 457, 0, 1024, 2892, 0},
    {"rmnp_dem_wgs84_nonsquare.tif", "GTiff", 152, 187, 0, 2281, 4261, 0},
    {"N42E001.hgt", "SRTMHGT", 1201, 1201, 7652, 349, 3100, 0},
    {"N41E001.hgt", "SRTMHGT", 1201, 1201, 134, -20, 1204, 0},
    {"pyrenees_mosaic.vrt", "VRT", 1201, 2401, 7786, -20, 3100, 0},
    {"N48W125.hgt.zip", "SRTMHGT", 3601, 3601, 6483876, -13, 1095, 0},
    {"rainier_adams_srtm90m_cog_lerc.tif", "GTiff", 1201, 1201, 9033, 263, 4371, 0},
    {"n35e138_fuji.dt1", "DTED", 1201, 1201, 2437, -16, 3742, 0},
    {"n35e138_fuji.dt0", "DTED", 121, 121, 25, -12, 3644, 0},
    {"trinidad_usgs1deg_feet.tif", "GTiff", 2401, 1201, 0, 4457.52 * kFoot_m, 14176.16 * kFoot_m, 0.01},
    {"hawaii_etopo5_antimeridian_km.nc", "netCDF", 725, 534, 0, -7438, 2804, 0.001, "EPSG:4326"},
    {"vanderford_multibeam_64m_epsg3031_cog.tif", "GTiff", 2581, 1998, 4792614, -2340, -19, 0.5},
    {"nrw_lidar_dsm1m_utm32n.tif", "GTiff", 1000, 1000, 0, 87.3, 167.7, 0.05},
    {"tirol_wog_5m_mgi_lambert.asc", "AAIGrid", 490, 555, 94079, 1249, 2544, 0.5},
};

std::filesystem::path in_collection(const std::string& name) {
    return std::filesystem::path(OVERFLY_SHARED_DATA) / "dem" / name;
}

class SharedData : public testing::TestWithParam<Expected> {};
INSTANTIATE_TEST_SUITE_P(Of, SharedData, testing::ValuesIn(kFiles), [](const auto& test) {
    std::string name = test.param.file;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
});

TEST_P(SharedData, IsReadAndMeshed) {
    const Expected& expected = GetParam();
    const ElevationFile elevation = read_elevation({.dem = {in_collection(expected.file)}, .crs = expected.crs});
    const ElevationReport& r = elevation.report;
    EXPECT_EQ(r.driver, expected.driver);
    EXPECT_EQ(r.columns, expected.columns);
    EXPECT_EQ(r.rows, expected.rows);
    EXPECT_EQ(elevation.model->size() - r.valid_count, expected.void_count);
    EXPECT_NEAR(r.lowest_m, expected.lowest_m, expected.tolerance_m);
    EXPECT_NEAR(r.highest_m, expected.highest_m, expected.tolerance_m);
    const TerrainMesh mesh = triangulate(*elevation.model, SceneFrame(elevation.centre), elevation.locate);
    EXPECT_GT(mesh.triangles.size(), r.valid_count);
    EXPECT_LE(mesh.positions.size(), r.valid_count);
}

TEST(SharedData, EveryFileIsKnown) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(in_collection("")))
        if (entry.path().extension() != ".prj") ++count;
    EXPECT_EQ(count, kFiles.size());
}

TEST(SharedData, TheFileWithoutACrsIsRefusedUntilOneIsStated) {
    try {
        (void)read_elevation({.dem = {in_collection("hawaii_etopo5_antimeridian_km.nc")}});
        FAIL() << "it was read";
    } catch (const UserError& error) {
        EXPECT_NE(std::string(error.what()).find("state one with crs:"), std::string::npos) << error.what();
    }
}

TEST(SharedData, LongitudesGoOnBeyondTheAntimeridian) {
    const ElevationFile hawaii =
        read_elevation({.dem = {in_collection("hawaii_etopo5_antimeridian_km.nc")}, .crs = "EPSG:4326"});
    EXPECT_NEAR(hawaii.report.extent.west_deg, 159.8, 0.1);
    EXPECT_NEAR(hawaii.report.extent.east_deg, 220.2, 0.1);
    EXPECT_EQ(hawaii.report.vertical_unit.name, "km");
}

TEST(SharedData, TilesJoinAsTheVrtDoes) {
    const ElevationFile tiles = read_elevation({.dem = {in_collection("N41E001.hgt"), in_collection("N42E001.hgt")}});
    const ElevationFile vrt = read_elevation({.dem = {in_collection("pyrenees_mosaic.vrt")}});
    EXPECT_EQ(tiles.model->rows, 2401);
    EXPECT_EQ(tiles.report.valid_count, vrt.report.valid_count);
    EXPECT_EQ(tiles.report.extent, vrt.report.extent);
}

TEST(SharedData, PicturesAndVectorsAreRefused) {
    const std::filesystem::path data(OVERFLY_SHARED_DATA);
    for (const char* const name : {"imagery/rmnp_landsat_rgb_wgs84.tif", "imagery/zion_nlcd2011_utm12n.tif",
                                   "vector/zion_park_boundary.gpkg", "vector/rmnp_lake_naturalearth.geojson"}) {
        ASSERT_TRUE(std::filesystem::exists(data / name)) << name;
        EXPECT_THROW((void)read_elevation({.dem = {data / name}}), UserError) << name;
    }
}

}  // namespace
}  // namespace overfly
