#include "io/elevation_file.h"

#include <cmath>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "io/sample_raster.h"
#include "io/temporary_folder.h"
#include "terrain/mesh_laws.h"

namespace overfly {
namespace {

std::vector<Geodetic> row_of(const ElevationFile& elevation, int row) {
    std::vector<Geodetic> places(static_cast<std::size_t>(elevation.model->columns));
    elevation.locate(row, places);
    return places;
}

// Same samples at the same places, heights within `tolerance_m`.
void expect_same_terrain(const ElevationFile& a, const ElevationFile& b, double tolerance_m = 1e-3) {
    ASSERT_EQ(a.model->columns, b.model->columns);
    ASSERT_EQ(a.model->rows, b.model->rows);
    EXPECT_EQ(a.model->is_valid, b.model->is_valid);
    for (const int row : {0, a.model->rows / 2, a.model->rows - 1}) {
        const std::vector<Geodetic> p = row_of(a, row), q = row_of(b, row);
        for (std::size_t i = 0; i < p.size(); i += 7) {
            if (a.model->is_valid[a.model->index(static_cast<int>(i), row)] == 0) continue;
            EXPECT_LT(geodesic_length_m(p[i], q[i]), 1e-3) << "row " << row << ", column " << i;
            EXPECT_NEAR(p[i].height_m, q[i].height_m, tolerance_m) << "row " << row << ", column " << i;
        }
    }
}

// Ellipsoidal heights of the sample DEM between its samples, found with GDAL's projection.
class BlancaSurface {
  public:
    [[nodiscard]] double height_m(const Geodetic& place) const {
        const auto p = utm_({place.lon.degrees(), place.lat.degrees(), 0});
        const double x = (p[0] - 436050) / 75 - 0.5, y = (4203000 - p[1]) / 75 - 0.5;
        const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
        if (column < 1 || row < 1 || column > 691 || row > 677) return std::numeric_limits<double>::quiet_NaN();
        const double u = x - column, v = y - row;
        const auto at = [&](int c, int r) {
            return static_cast<double>(dem_.model->height_m[dem_.model->index(c, r)]);
        };
        return (1 - v) * ((1 - u) * at(column, row) + u * at(column + 1, row)) +
               v * ((1 - u) * at(column, row + 1) + u * at(column + 1, row + 1));
    }

  private:
    ElevationFile dem_ = read_elevation({.dem = {blanca()}});
    Proj utm_{"EPSG:4326", "EPSG:32613"};
};

// A variant on another grid, made with bilinear weights, is the same surface up to the rounding of its numbers. (As
// long as it is finer than the original: gdalwarp widens its weights on the way to a coarser grid.)
void expect_on_blanca(const ElevationFile& variant, double tolerance_m) {
    const BlancaSurface surface;
    int compared = 0;
    const ElevationModel& model = *variant.model;
    for (int row = 0; row < model.rows; row += 41) {
        const std::vector<Geodetic> places = row_of(variant, row);
        for (int column = 0; column < model.columns; column += 37) {
            if (model.is_valid[model.index(column, row)] == 0) continue;
            const double expected_m = surface.height_m(places[static_cast<std::size_t>(column)]);
            if (std::isnan(expected_m)) continue;
            ++compared;
            EXPECT_NEAR(static_cast<double>(model.height_m[model.index(column, row)]), expected_m, tolerance_m)
                << "column " << column << ", row " << row;
        }
    }
    EXPECT_GT(compared, 100);
}

TEST(ElevationFile, ReadsTheSampleDem) {
    const ElevationFile elevation = read_elevation({.dem = {blanca()}});
    const ElevationReport& r = elevation.report;
    EXPECT_EQ(r.files, std::vector{blanca()});
    EXPECT_EQ(r.driver, "GTiff");
    EXPECT_EQ(r.crs_name, "WGS 84 / UTM zone 13N");
    EXPECT_EQ(r.crs_authority, "EPSG:32613");
    EXPECT_EQ(r.columns, 694);
    EXPECT_EQ(r.rows, 680);
    EXPECT_EQ(r.column_spacing, 75.0);
    EXPECT_EQ(r.row_spacing, 75.0);
    EXPECT_EQ(r.spacing_unit, "metre");
    EXPECT_EQ(r.vertical_unit.name, "m");
    EXPECT_EQ(text(r.vertical_unit_provenance), "assumed");
    EXPECT_EQ(r.vertical.name, "EGM96 geoid");
    EXPECT_EQ(text(r.vertical.provenance), "assumed");
    EXPECT_FALSE(r.no_data.has_value());
    EXPECT_EQ(r.valid_count, 471920U);
    EXPECT_EQ(r.no_data_share, 0.0);
    EXPECT_EQ(r.lowest_m, 2087.0);
    EXPECT_EQ(r.highest_m, 4260.0);
    EXPECT_NEAR(r.extent.west_deg, -105.728, 1e-3);
    EXPECT_NEAR(r.extent.east_deg, -105.135, 1e-3);
    EXPECT_NEAR(r.extent.south_deg, 37.513, 1e-3);
    EXPECT_NEAR(r.extent.north_deg, 37.974, 1e-3);
    EXPECT_NEAR(elevation.centre.lon.degrees(), -105.430, 1e-3);
    EXPECT_NEAR(elevation.centre.lat.degrees(), 37.744, 1e-3);
}

TEST(ElevationFile, MakesThePinnedMeshOfTheSampleDem) {
    const ElevationFile elevation = read_elevation({.dem = {blanca()}});
    const SceneFrame frame(elevation.centre);
    const TerrainMesh mesh = triangulate(*elevation.model, frame, elevation.locate);
    EXPECT_EQ(mesh.positions.size(), 471'920U);
    EXPECT_EQ(mesh.triangles.size(), 941'094U);
    EXPECT_EQ(broken_mesh_law(mesh, frame), "");
}

TEST(ElevationFile, MovedLocatorKeepsItsSamples) {
    LocateRow locate;
    {
        ElevationFile elevation = read_elevation({.dem = {blanca()}});
        locate = std::move(elevation.locate);
    }
    std::vector<Geodetic> places(694);
    locate(300, places);
    EXPECT_GT(places[300].height_m, 2000.0);
}

struct Variant {
    std::string name, options;
};
class ElevationFormat : public testing::TestWithParam<Variant> {};
INSTANTIATE_TEST_SUITE_P(Of, ElevationFormat,
                         testing::Values(Variant{"blanca.asc", "-of AAIGrid"}, Variant{"blanca.nc", "-of netCDF"},
                                         Variant{"blanca.gpkg", "-of GPKG"}, Variant{"blanca.vrt", "-of VRT"},
                                         Variant{"cog.tif", "-of COG -co COMPRESS=LZW"},
                                         Variant{"float.tif", "-ot Float32 -co TILED=YES"},
                                         Variant{"double.tif", "-ot Float64"}, Variant{"unsigned.tif", "-ot UInt16"},
                                         Variant{"blanca.img", "-of HFA"}),
                         [](const auto& test) {
                             std::string name = test.param.name;
                             std::replace(name.begin(), name.end(), '.', '_');
                             return name;
                         });

TEST_P(ElevationFormat, HoldsTheSameTerrain) {
    const TemporaryFolder folder;
    translate(blanca(), folder / GetParam().name, GetParam().options);
    expect_same_terrain(read_elevation({.dem = {folder / GetParam().name}}), read_elevation({.dem = {blanca()}}));
}

TEST(ElevationFile, ReadsFromAnArchiveInPlace) {
    const TemporaryFolder folder;
    zip(blanca(), folder / "anything.zip");
    const ElevationFile elevation = read_elevation({.dem = {folder / "anything.zip"}});
    EXPECT_EQ(elevation.report.files, std::vector{folder / "anything.zip"});
    EXPECT_EQ(folder.file_count(), 1U) << "nothing is unpacked";
    expect_same_terrain(elevation, read_elevation({.dem = {blanca()}}));
}

TEST(ElevationFile, NamesAllFilesOfAVrt) {
    const TemporaryFolder folder;
    translate(blanca(), folder / "blanca.vrt", "-of VRT");
    const ElevationFile elevation = read_elevation({.dem = {folder / "blanca.vrt"}});
    ASSERT_EQ(elevation.report.files.size(), 2U);
    EXPECT_TRUE(std::filesystem::equivalent(elevation.report.files[1], blanca()));
}

class ElevationCrs : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Of, ElevationCrs,
                         testing::Values("EPSG:4326", "EPSG:3857", "EPSG:32612", "EPSG:5070", "EPSG:4269",
                                         "EPSG:2232"));

TEST_P(ElevationCrs, HoldsTheSameTerrain) {
    const TemporaryFolder folder;
    warp(blanca(), folder / "v.tif",
         std::string("-ot Float32 -r bilinear -et 0 -dstnodata -9999 -ts 1400 1400 -t_srs ") + GetParam());
    // PROJ may choose a shift of a few metres between NAD83 and WGS84, and not the same way back.
    expect_on_blanca(read_elevation({.dem = {folder / "v.tif"}}), 0.2);
}

// Tiles as the shuttle mission and DTED have them: posts on whole degrees, voids around our data.
TEST(ElevationFile, ReadsSrtmAndDtedTiles) {
    const TemporaryFolder folder;
    warp(blanca(), folder / "tile.tif",
         "-t_srs EPSG:4326 -te -106.0001388889 36.9998611111 -104.9998611111 38.0001388889 -ts 3601 3601 "
         "-r bilinear -et 0 -dstnodata -32768");
    translate(folder / "tile.tif", folder / "N37W106.hgt", "-of SRTMHGT");
    translate(folder / "tile.tif", folder / "n37.dt2", "-of DTED");
    zip(folder / "N37W106.hgt", folder / "N37W106.hgt.zip");
    for (const char* const name : {"N37W106.hgt", "N37W106.hgt.zip", "n37.dt2"}) {
        const ElevationFile elevation = read_elevation({.dem = {folder / name}});
        EXPECT_EQ(elevation.report.columns, 3601) << name;
        EXPECT_NEAR(elevation.report.extent.west_deg, -106.0, 1e-9) << name;
        EXPECT_NEAR(elevation.report.extent.north_deg, 38.0, 1e-9) << name;
        EXPECT_EQ(text(elevation.report.vertical.provenance), "from the file") << name;
        EXPECT_GT(elevation.report.no_data_share, 0.5) << name;
        expect_on_blanca(elevation, 0.51);  // whole metres
    }
}

TEST(ElevationFile, ReadsSouthUpAndRotatedGrids) {
    const TemporaryFolder folder;
    // The same 3x2 samples: as they are; with rows from the south; with columns for rows.
    const SampleRaster plain;
    SampleRaster south_up = plain, turned = plain;
    south_up.values = {130, 140, 150, 100, 110, 120};
    south_up.crs_from_pixel = {{470'000, 30, 0, 4'180'000 - 60, 0, 30}};
    turned.columns = 2;
    turned.rows = 3;
    turned.values = {100, 130, 110, 140, 120, 150};
    turned.crs_from_pixel = {{470'000, 0, 30, 4'180'000, -30, 0}};
    write_raster(folder / "plain.tif", plain);
    write_raster(folder / "south_up.tif", south_up);
    write_raster(folder / "turned.tif", turned);

    const ElevationFile a = read_elevation({.dem = {folder / "plain.tif"}});
    const ElevationFile b = read_elevation({.dem = {folder / "south_up.tif"}});
    const ElevationFile c = read_elevation({.dem = {folder / "turned.tif"}});
    for (int row = 0; row < 2; ++row)
        for (std::size_t column = 0; column < 3; ++column) {
            const Geodetic p = row_of(a, row)[column];
            const Geodetic q = row_of(b, 1 - row)[column];
            const Geodetic r = row_of(c, static_cast<int>(column))[static_cast<std::size_t>(row)];
            EXPECT_LT(geodesic_length_m(p, q), 1e-6);
            EXPECT_LT(geodesic_length_m(p, r), 1e-6);
            EXPECT_NEAR(p.height_m, q.height_m, 1e-6);
            EXPECT_NEAR(p.height_m, r.height_m, 1e-6);
        }
    for (const ElevationFile& file : {a, b, c}) {
        const SceneFrame frame(file.centre);
        EXPECT_EQ(broken_mesh_law(triangulate(*file.model, frame, file.locate), frame), "");
    }
}

std::vector<float> heights_of(const SampleRaster& raster, ElevationSource source = {}) {
    const TemporaryFolder folder;
    write_raster(folder / "a.tif", raster);
    source.dem = {folder / "a.tif"};
    return read_elevation(source).model->height_m;
}

std::vector<std::uint8_t> valid_of(const SampleRaster& raster, ElevationSource source = {}) {
    const TemporaryFolder folder;
    write_raster(folder / "a.tif", raster);
    source.dem = {folder / "a.tif"};
    return read_elevation(source).model->is_valid;
}

TEST(ElevationFile, HonoursScaleOffsetAndUnit) {
    SampleRaster raster;
    raster.type = "Int16";
    raster.scale = 0.5;
    raster.offset = -20.0;
    EXPECT_EQ(heights_of(raster), (std::vector<float>{30, 35, 40, 45, 50, 55}));
    raster.unit = "ft";
    EXPECT_FLOAT_EQ(heights_of(raster)[5], 55.0F * 0.3048F);
    raster.unit = "US survey foot";
    EXPECT_FLOAT_EQ(heights_of(raster)[5], static_cast<float>(55.0 * 1200.0 / 3937.0));
    EXPECT_EQ(heights_of(raster, {.vertical_unit = "m"})[5], 55.0F) << "what is stated wins";
}

TEST(ElevationFile, TakesTheUnitOfTheVerticalCrs) {
    SampleRaster raster;
    raster.crs = "EPSG:32613+8228";  // NAVD88 height in feet
    const std::vector<float> heights_m = heights_of(raster, {.vertical_datum = VerticalDatum::Egm96});
    EXPECT_FLOAT_EQ(heights_m[5], 150.0F * 0.3048F);
}

TEST(ElevationFile, MasksNoDataOfEveryKind) {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr auto kHuge = static_cast<double>(std::numeric_limits<float>::max());
    const std::vector<std::uint8_t> expected = {1, 0, 1, 1, 1, 1};
    SampleRaster raster;
    for (const double no_data : {-9999.0, 32767.0, 0.0, kHuge, -kHuge, -3.4e38, kNaN}) {
        raster.no_data = no_data;
        raster.values = {100, no_data, 120, 130, 140, 150};
        EXPECT_EQ(valid_of(raster), expected) << no_data;
    }
    raster.no_data.reset();
    raster.values[1] = kNaN;
    EXPECT_EQ(valid_of(raster), expected) << "what is no number is not measured, declared or not";
    raster.values[1] = -500;
    EXPECT_EQ(valid_of(raster, {.no_data = -500}), expected) << "stated";
    raster.values[1] = 110;
    raster.mask = {255, 0, 255, 255, 255, 255};
    EXPECT_EQ(valid_of(raster), expected) << "a mask band";
}

TEST(ElevationFile, CountsVoids) {
    const TemporaryFolder folder;
    SampleRaster raster;
    raster.no_data = -9999;
    raster.values[2] = -9999;
    write_raster(folder / "a.tif", raster);
    const ElevationReport r = read_elevation({.dem = {folder / "a.tif"}}).report;
    EXPECT_EQ(r.valid_count, 5U);
    EXPECT_NEAR(r.no_data_share, 1.0 / 6.0, 1e-12);
    EXPECT_EQ(r.lowest_m, 100.0);
}

TEST(ElevationFile, TakesTheStatedBand) {
    SampleRaster raster;
    raster.bands = 2;
    EXPECT_EQ(heights_of(raster, {.band = 1})[5], 150.0F);
    EXPECT_EQ(heights_of(raster, {.band = 2})[5], 0.0F);
}

ElevationFile read_with_crs(const TemporaryFolder& folder, const std::string& crs, const ElevationSource& how = {}) {
    SampleRaster raster;
    raster.crs = crs;
    write_raster(folder / "a.tif", raster);
    ElevationSource source = how;
    source.dem = {folder / "a.tif"};
    return read_elevation(source);
}

// At this place the EGM96 geoid is 15 m below the ellipsoid.
TEST(ElevationFile, BringsHeightsToTheEllipsoid) {
    const TemporaryFolder folder;
    const auto raised_m = [&](const std::string& crs, const ElevationSource& source) {
        return row_of(read_with_crs(folder, crs, source), 0)[0].height_m - 100.0;
    };
    EXPECT_NEAR(raised_m("EPSG:32613", {}), -15.0, 1.5);
    EXPECT_NEAR(raised_m("EPSG:32613", {.vertical_datum = VerticalDatum::Egm96}), -15.0, 1.5);
    EXPECT_EQ(raised_m("EPSG:32613", {.vertical_datum = VerticalDatum::Ellipsoid}), 0.0);
    EXPECT_EQ(raised_m("EPSG:32613", {.vertical_datum = VerticalDatum::Offset, .vertical_offset_m = -2.5}), -2.5);
    EXPECT_NEAR(raised_m("EPSG:32613+5773", {}), -15.0, 1.5);
    EXPECT_EQ(raised_m("EPSG:32613+5703", {.vertical_datum = VerticalDatum::Ellipsoid}), 0.0);
}

TEST(ElevationFile, SaysHowItKnowsTheDatum) {
    const TemporaryFolder folder;
    using enum VerticalDatum;
    const auto vertical = [&](const std::string& crs, const ElevationSource& source = {}) {
        return read_with_crs(folder, crs, source).report.vertical;
    };
    EXPECT_EQ(vertical("EPSG:32613"), (VerticalReference{Egm96, 0, "EGM96 geoid", Provenance::Assumed}));
    EXPECT_EQ(vertical("EPSG:32613", {.vertical_datum = Egm96}).provenance, Provenance::Stated);
    EXPECT_EQ(vertical("EPSG:32613+5773"), (VerticalReference{Egm96, 0, "EGM96 geoid", Provenance::FromFile}));
    EXPECT_EQ(vertical("EPSG:32613+5714").provenance, Provenance::Assumed) << "some mean sea level";
}

TEST(ElevationFile, KnowsEllipsoidalHeightsOfTheCrs) {
    const TemporaryFolder folder;
    const ElevationFile stated = read_with_crs(folder, "EPSG:32613", {.crs = "EPSG:32613"});
    EXPECT_EQ(stated.report.vertical.provenance, Provenance::Assumed);
    SampleRaster raster;
    raster.crs_from_pixel = {{-105, 0.001, 0, 38, 0, -0.001}};
    raster.crs = "";
    write_raster(folder / "b.tif", raster);
    const ElevationReport r = read_elevation({.dem = {folder / "b.tif"}, .crs = "EPSG:4979"}).report;
    EXPECT_EQ(r.vertical, (VerticalReference{VerticalDatum::Ellipsoid, 0, "ellipsoid", Provenance::FromFile}));
}

TEST(ElevationFile, CrossesTheAntimeridianAndThePole) {
    const TemporaryFolder folder;
    SampleRaster raster;
    raster.crs = "EPSG:4326";
    raster.crs_from_pixel = {{179.998, 0.002, 0, -16, 0, -0.002}};
    write_raster(folder / "fiji.tif", raster);
    const GeographicExtent fiji = read_elevation({.dem = {folder / "fiji.tif"}}).report.extent;
    EXPECT_NEAR(fiji.west_deg, 179.999, 1e-9);
    EXPECT_NEAR(fiji.east_deg, 180.003, 1e-9);

    raster.crs = "EPSG:3031";
    raster.crs_from_pixel = {{-1500, 1000, 0, 1000, 0, -1000}};
    write_raster(folder / "pole.tif", raster);
    const ElevationFile pole = read_elevation({.dem = {folder / "pole.tif"}});
    EXPECT_EQ(pole.report.extent.west_deg, -180.0);
    EXPECT_EQ(pole.report.extent.east_deg, 180.0);
    EXPECT_EQ(pole.report.extent.south_deg, -90.0);
    EXPECT_LT(pole.report.extent.north_deg, -89.9);
    const SceneFrame frame(pole.centre);
    EXPECT_EQ(broken_mesh_law(triangulate(*pole.model, frame, pole.locate), frame), "");
}

}  // namespace
}  // namespace overfly
