// One file, or pair of files, per thing that is refused, and the words it is refused with.

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/elevation_file.h"
#include "io/sample_raster.h"
#include "io/temporary_folder.h"

#include <ogr_srs_api.h>

namespace overfly {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

const std::string kWasRead = "(it was read)";

// The one line that is said about it; nothing may come from GDAL beside it.
std::string refusal(const ElevationSource& source) {
    std::string said = kWasRead;
    testing::internal::CaptureStderr();
    try {
        const ElevationFile elevation = read_elevation(source);
        std::vector<Geodetic> places(static_cast<std::size_t>(elevation.model->columns));
        for (int row = 0; row < elevation.model->rows; ++row) elevation.locate(row, places);
    } catch (const UserError& error) {
        said = error.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 0) << said;
    return said;
}

class ElevationRefusal : public testing::Test {
  protected:
    std::string refusal_of(const SampleRaster& raster, ElevationSource source = {}) {
        write_raster(folder_ / "dem.tif", raster);
        source.dem = {folder_ / "dem.tif"};
        const std::string said = refusal(source);
        EXPECT_THAT(said, testing::AnyOf(kWasRead, testing::StartsWith((folder_ / "dem.tif").string() + ": ")));
        return said;
    }
    std::filesystem::path text_file(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }

    TemporaryFolder folder_;
    SampleRaster raster_;
};

TEST_F(ElevationRefusal, NotFound) {
    EXPECT_EQ(refusal({.dem = {folder_ / "no.tif"}}), (folder_ / "no.tif").string() + ": not found");
}

TEST_F(ElevationRefusal, NotARaster) {
    EXPECT_THAT(refusal({.dem = {text_file("a.txt", "hello")}}),
                AllOf(HasSubstr("a.txt: can't be opened as a raster: "), HasSubstr("not recognized")));
}

TEST_F(ElevationRefusal, AFolder) {
    EXPECT_THAT(refusal({.dem = {folder_.path()}}), HasSubstr("can't be opened as a raster: "));
}

TEST_F(ElevationRefusal, Vectors) {
    const auto file = text_file("a.geojson", R"({"type":"Point","coordinates":[1,2]})");
    EXPECT_THAT(refusal({.dem = {file}}), EndsWith("a.geojson: holds vector data (GeoJSON), not a raster of heights"));
}

TEST_F(ElevationRefusal, TruncatedTiff) {
    translate(blanca(), folder_ / "a.tif", "-co COMPRESS=NONE");
    std::filesystem::resize_file(folder_ / "a.tif", std::filesystem::file_size(folder_ / "a.tif") / 2);
    EXPECT_THAT(refusal({.dem = {folder_ / "a.tif"}}), HasSubstr("a.tif: can't be"));
}

TEST_F(ElevationRefusal, TruncatedTextGrid) {
    translate(blanca(), folder_ / "a.asc", "-of AAIGrid");
    std::filesystem::resize_file(folder_ / "a.asc", std::filesystem::file_size(folder_ / "a.asc") / 2);
    EXPECT_THAT(refusal({.dem = {folder_ / "a.asc"}}), HasSubstr("a.asc: can't be read to the end: "));
}

TEST_F(ElevationRefusal, DamagedCompression) {
    translate(blanca(), folder_ / "a.tif", "-co COMPRESS=DEFLATE");
    {
        std::fstream file(folder_ / "a.tif", std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(static_cast<std::streamoff>(std::filesystem::file_size(folder_ / "a.tif") / 2));
        // Many strips, with their beginnings: zlib takes damage inside of one for other heights.
        file << std::string(60'000, '\xff');
    }
    EXPECT_THAT(refusal({.dem = {folder_ / "a.tif"}}), HasSubstr("a.tif: can't be read to the end: "));
}

TEST_F(ElevationRefusal, VrtWithoutItsParts) {
    std::filesystem::copy_file(blanca(), folder_ / "part.tif");
    translate(folder_ / "part.tif", folder_ / "a.vrt", "-of VRT");
    std::filesystem::remove(folder_ / "part.tif");
    EXPECT_THAT(refusal({.dem = {folder_ / "a.vrt"}}), AllOf(HasSubstr("a.vrt: can't be"), HasSubstr("part.tif")));
}

TEST_F(ElevationRefusal, ArchiveWithoutARaster) {
    zip(text_file("a.txt", "hello"), folder_ / "a.zip");
    EXPECT_THAT(refusal({.dem = {folder_ / "a.zip"}}), EndsWith("the archive holds no raster that GDAL opens"));
}

TEST_F(ElevationRefusal, ArchiveWithSeveralRasters) {
    write_raster(folder_ / "a.tif", raster_);
    write_raster(folder_ / "b.tif", raster_);
    zip(folder_ / "a.tif", folder_ / "a.zip");
    zip(folder_ / "b.tif", folder_ / "a.zip");
    EXPECT_THAT(refusal({.dem = {folder_ / "a.zip"}}), HasSubstr("the archive holds 2 rasters; unpack it"));
}

TEST_F(ElevationRefusal, NoCrs) {
    raster_.crs = "";
    EXPECT_THAT(refusal_of(raster_), HasSubstr("has no coordinate reference system; state one with crs:"));
    EXPECT_EQ(refusal_of(raster_, {.crs = "EPSG:32613"}), kWasRead);
}

TEST_F(ElevationRefusal, UnknownStatedCrs) {
    EXPECT_THAT(refusal_of(raster_, {.crs = "EPSG:1"}), HasSubstr("crs: \"EPSG:1\" is no coordinate reference system"));
}

TEST_F(ElevationRefusal, CrsWithoutAPlaceOnEarth) {
    raster_.crs = R"(LOCAL_CS["site grid",UNIT["metre",1]])";
    EXPECT_THAT(refusal_of(raster_), HasSubstr("its CRS \"site grid\" is neither geographic nor projected"));
    EXPECT_THAT(refusal_of(SampleRaster(), {.crs = "EPSG:4978"}), HasSubstr("neither geographic nor projected"));
}

TEST_F(ElevationRefusal, CrsOfAnUnknownDatum) {
    raster_.crs = R"(GEOGCS["old",DATUM["of the captain",SPHEROID["his",6377000,300]],PRIMEM["Greenwich",0],)"
                  R"(UNIT["degree",0.0174532925199433]])";
    raster_.crs_from_pixel = {{10, 0.1, 0, 50, 0, -0.1}};
    EXPECT_THAT(refusal_of(raster_), HasSubstr("no transformation from its CRS \"old\" to WGS84 is known"));
}

TEST_F(ElevationRefusal, SeveralBands) {
    raster_.bands = 3;
    EXPECT_THAT(refusal_of(raster_), EndsWith("has 3 bands; state the one with the heights with band:"));
    EXPECT_THAT(refusal_of(raster_, {.band = 4}), EndsWith("band: 4 is stated, the file has 3 band(s)"));
}

TEST_F(ElevationRefusal, Palette) {
    raster_.type = "Byte";
    raster_.has_palette = true;
    EXPECT_THAT(refusal_of(raster_), HasSubstr("indices into a colour palette"));
}

TEST_F(ElevationRefusal, ComplexNumbers) {
    raster_.type = "CFloat32";
    EXPECT_THAT(refusal_of(raster_), EndsWith("has complex numbers (CFloat32), not heights"));
}

TEST_F(ElevationRefusal, FewerThan2x2Samples) {
    raster_.rows = 1;
    EXPECT_THAT(refusal_of(raster_), EndsWith("has 3x1 samples; a surface needs at least 2x2"));
}

TEST_F(ElevationRefusal, NoValidSample) {
    raster_.no_data = 7;
    raster_.values.assign(6, 7);
    EXPECT_THAT(refusal_of(raster_), EndsWith("has no valid sample, only no-data"));
}

TEST_F(ElevationRefusal, NoPlace) {
    raster_.crs_from_pixel.reset();
    EXPECT_THAT(refusal_of(raster_), EndsWith("does not say where it lies (no geotransform, no world file)"));
}

TEST_F(ElevationRefusal, SamplesWithoutArea) {
    raster_.crs_from_pixel = {{470'000, 30, 30, 4'180'000, 30, 30}};
    EXPECT_THAT(refusal_of(raster_), EndsWith("its geotransform has samples without any area"));
}

TEST_F(ElevationRefusal, UnknownUnit) {
    raster_.unit = "furlong";
    EXPECT_THAT(refusal_of(raster_), HasSubstr("heights are in \"furlong\", which is not known; state vertical_unit:"));
    EXPECT_EQ(refusal_of(raster_, {.vertical_unit = "m"}), kWasRead);
    EXPECT_THAT(refusal_of(raster_, {.vertical_unit = "hand"}), HasSubstr("vertical_unit: \"hand\" is not known"));
}

TEST_F(ElevationRefusal, HeightsThatAreNotOnEarth) {
    raster_.values[3] = -32768;
    EXPECT_THAT(refusal_of(raster_),
                HasSubstr("heights run from -32768 to 150 m, which is not on Earth; state no_data:"));
}

TEST_F(ElevationRefusal, SamplesOutsideTheCrs) {
    raster_.crs = "EPSG:4326";  // but the numbers are metres
    EXPECT_THAT(refusal_of(raster_), HasSubstr("has no place on Earth in CRS \"WGS 84\""));
    raster_.crs_from_pixel = {{10, 30, 0, 100, 0, -40}};  // the middle is on Earth, the first row is not
    raster_.rows = 3;
    raster_.values = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    raster_.crs_from_pixel = {{10, 1, 0, 140, 0, -40}};
    EXPECT_THAT(refusal_of(raster_), HasSubstr("row 0 has no place on Earth"));
}

TEST_F(ElevationRefusal, DatumsWithoutAnExactConversion) {
    raster_.crs = "EPSG:32613+5703";
    EXPECT_THAT(refusal_of(raster_), AllOf(HasSubstr("NAVD88 height"), HasSubstr("state vertical_datum:")));
    raster_.crs = "EPSG:32613+3855";
    EXPECT_THAT(refusal_of(raster_), HasSubstr("EGM2008 height"));
    // WGS 72 with heights above its own ellipsoid.
    raster_.crs_from_pixel = {{10, 0.1, 0, 50, 0, -0.1}};
    EXPECT_THAT(refusal_of(raster_, {.crs = "EPSG:4985"}),
                AllOf(HasSubstr("heights from the ellipsoid of WGS 72"), HasSubstr("state vertical_datum:")));
}

TEST_F(ElevationRefusal, SaysAllAtOnce) {
    raster_.crs = "";
    raster_.bands = 2;
    raster_.crs_from_pixel.reset();
    write_raster(folder_ / "dem.tif", raster_);
    try {
        (void)read_elevation({.dem = {folder_ / "dem.tif", folder_ / "no.tif"}});
        FAIL() << "it was read";
    } catch (const UserError& error) {
        EXPECT_EQ(error.problems().size(), 4U) << error.what();
    }
}

TEST_F(ElevationRefusal, NoGeoidInstalled) {
    write_raster(folder_ / "dem.tif", raster_);
    const ElevationSource source{.dem = {folder_ / "dem.tif"}};
    // PROJ keeps its database open, so only the search for the geoid sees the empty folder.
    (void)read_elevation(source);
    const std::string empty = folder_.path().string();
    const char* const folders[] = {empty.c_str(), nullptr};
    OSRSetPROJSearchPaths(folders);
    std::string said;
    try {
        (void)read_elevation({.dem = source.dem, .vertical_datum = VerticalDatum::Egm96});
    } catch (const UserError& error) {
        said = error.what();
    }
    OSRSetPROJSearchPaths(nullptr);
    EXPECT_THAT(said, HasSubstr("install proj-data"));
}

}  // namespace
}  // namespace overfly
