#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "config/read.h"
#include "config/sample_documents.h"

namespace overfly {
namespace {

using namespace config_tests;
namespace fs = std::filesystem;

const fs::path sample_dem = source_folder / "terrain/blanca_peak_utm13n_75m.tif";

TEST(ReadTerrainDocument, ReadsEveryKey) {
    const TerrainDocument terrain = read_terrain_document(good_folder / "terrain.yaml");
    const ElevationSource expected{.dem = {sample_dem},
                                   .band = 1,
                                   .crs = "EPSG:32613",
                                   .no_data = -9999.0,
                                   .vertical_unit = "m",
                                   .vertical_datum = VerticalDatum::Offset,
                                   .vertical_offset_m = -16.5};
    EXPECT_EQ(terrain.source, expected);
    EXPECT_EQ(terrain.file, good_folder / "terrain.yaml");
}

TEST(ReadTerrainDocument, LeavesUnsaidWhatTheFilesSay) {
    const TemporaryFolder folder;
    const auto file = folder.write("t.yaml", "dem: " + sample_dem.string() + "\n");
    const ElevationSource expected{.dem = {sample_dem}, .band = {}, .crs = {}, .no_data = {}, .vertical_unit = {}};
    EXPECT_EQ(read_terrain_document(file).source, expected);
}

TEST(ReadTerrainDocument, ReadsTheSampleOfTheRepository) {
    const TerrainDocument terrain = read_terrain_document(source_folder / "terrain/blanca_peak.yaml");
    EXPECT_EQ(terrain.source.dem, std::vector{sample_dem});
    EXPECT_EQ(terrain.source.vertical_datum, VerticalDatum::Egm96);
}

TEST(ReadTerrainDocument, KnowsTwoWordsForSeaLevel) {
    const TemporaryFolder folder;
    for (const std::string word : {"egm96", "sea_level"}) {
        const auto file = folder.write("t.yaml", "dem: " + sample_dem.string() + "\nvertical_datum: " + word + "\n");
        EXPECT_EQ(read_terrain_document(file).source.vertical_datum, VerticalDatum::Egm96);
    }
}

TEST(ReadTerrainDocument, KeepsTheNamesOfGdal) {
    const TemporaryFolder folder;
    const std::vector<std::string> names = {"/vsizip/a.zip/b.tif", "NETCDF:a.nc:z", "https://example.org/a.tif",
                                            "<VRTDataset></VRTDataset>", "GTIFF_DIR:2:a.tif"};
    std::string text = "dem:\n";
    for (const std::string& name : names) text += "  - '" + name + "'\n";
    const TerrainDocument terrain = read_terrain_document(folder.write("t.yaml", text));
    EXPECT_EQ(terrain.source.dem, std::vector<fs::path>(names.begin(), names.end()));
}

TEST(ReadTerrainDocument, TakesPathsFromTheDocumentsOwnFolder) {
    const TemporaryFolder folder;
    folder.write("rasters/a.tif", "");
    folder.write("elsewhere/b.tif", "");
    fs::create_directory_symlink(folder.path() / "elsewhere", folder.path() / "documents");
    folder.write("elsewhere/t.yaml", "dem: [b.tif, ../rasters/a.tif]\n");
    const TerrainDocument terrain = read_terrain_document(folder.path() / "documents/t.yaml");
    EXPECT_EQ(terrain.source.dem[0], folder.path() / "documents/b.tif");
    EXPECT_EQ(terrain.source.dem[1], folder.path() / "rasters/a.tif");
}

TEST(ReadTerrainDocument, KeepsDotsBehindALinkToElsewhere) {
    const TemporaryFolder folder;
    folder.write("far/away/t.yaml", "dem: ../a.tif\n");
    folder.write("far/a.tif", "");
    fs::create_directory_symlink("far/away", folder.path() / "near");
    const TerrainDocument terrain = read_terrain_document(folder.path() / "near/t.yaml");
    EXPECT_EQ(terrain.source.dem[0], folder.path() / "near/../a.tif");
    EXPECT_TRUE(fs::exists(terrain.source.dem[0]));
}

TEST(TerrainDocumentText, IsNeat) {
    TerrainDocument terrain;
    terrain.source.dem = {sample_dem};
    terrain.source.vertical_datum = VerticalDatum::Egm96;
    EXPECT_EQ(terrain_document_text(terrain, source_folder / "terrain"),
              "# Which rasters make the terrain, and what their numbers mean.\n"
              "dem: blanca_peak_utm13n_75m.tif\n"
              "vertical_datum: egm96\n");
}

TEST(TerrainDocumentText, ReadsBackAsTheSame) {
    const TemporaryFolder folder;
    TerrainDocument terrain{.file = folder.path() / "t.yaml", .source = {}};
    ElevationSource& source = terrain.source;
    source.dem = {folder.write("rasters/plain.tif", ""), folder.write("rasters/odd: name # 'quoted' \"twice\".tif", ""),
                  folder.write("rasters/- dash", ""), folder.write("rasters/null", ""), "NETCDF:\"a b.nc\":z"};
    source.band = 3;
    source.crs = "PROJCS[\"x\", \"y: z\"]";
    source.no_data = -3.4028234663852886e+38;
    source.vertical_unit = "us-ft";
    source.vertical_datum = VerticalDatum::Offset;
    source.vertical_offset_m = 0.1;
    folder.write("t.yaml", terrain_document_text(terrain, folder.path()));
    EXPECT_EQ(read_terrain_document(terrain.file).source, source);
}

TEST(TerrainDocumentText, KeepsNoDataThatIsNotANumber) {
    const TemporaryFolder folder;
    TerrainDocument terrain{.file = folder.path() / "t.yaml", .source = {}};
    terrain.source.dem = {folder.write("a.tif", "")};
    terrain.source.no_data = std::numeric_limits<double>::quiet_NaN();
    folder.write("t.yaml", terrain_document_text(terrain, folder.path()));
    EXPECT_TRUE(std::isnan(read_terrain_document(terrain.file).source.no_data.value()));
    terrain.source.no_data = -std::numeric_limits<double>::infinity();
    folder.write("t.yaml", terrain_document_text(terrain, folder.path()));
    EXPECT_EQ(read_terrain_document(terrain.file).source, terrain.source);
}

}  // namespace
}  // namespace overfly
