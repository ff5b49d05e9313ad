#include "shot/prepare_scene.h"

#include <fstream>

#include <gtest/gtest.h>

#include "config/read.h"
#include "core/error.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

// A hill of four by three posts 75 m apart, with `corner_m` in its first corner.
TerrainDocument write_hill(const std::filesystem::path& file, const std::string& corner_m) {
    std::ofstream(file) << "ncols 4\nnrows 3\nxllcorner 450000\nyllcorner 4150000\ncellsize 75\nNODATA_value -9999\n"
                        << corner_m << " 100 100 100\n100 150 150 100\n100 100 100 100\n";
    TerrainDocument document;
    document.source.dem = {file};
    document.source.crs = "EPSG:32613";
    return document;
}

TEST(PrepareScene, ComesFromTheCacheTheSecondTime) {
    const TemporaryFolder folder;
    const TerrainDocument hill = write_hill(folder / "hill.asc", "100");
    const PreparedTerrain first = prepare_terrain(hill, folder / "cache");
    EXPECT_FALSE(first.from_cache);
    EXPECT_EQ(first.scene.mesh.triangles.size(), 12U);
    const PreparedTerrain second = prepare_terrain(hill, folder / "cache");
    EXPECT_TRUE(second.from_cache);
    EXPECT_EQ(second.scene.mesh.positions, first.scene.mesh.positions);
    EXPECT_EQ(second.scene.mesh.triangles, first.scene.mesh.triangles);
    EXPECT_EQ(second.scene.mesh.twins, first.scene.mesh.twins);
    EXPECT_EQ(second.scene.report, first.scene.report);
    EXPECT_EQ(second.scene.origin, first.scene.origin);
}

TEST(PrepareScene, IsPreparedAnewWhenTheContentOrItsMeaningChanges) {
    const TemporaryFolder folder;
    TerrainDocument hill = write_hill(folder / "hill.asc", "100");
    const PreparedTerrain first = prepare_terrain(hill, folder / "cache");
    hill = write_hill(folder / "hill.asc", "101");
    const PreparedTerrain other_content = prepare_terrain(hill, folder / "cache");
    EXPECT_FALSE(other_content.from_cache);
    EXPECT_NE(other_content.scene.content_hash, first.scene.content_hash);

    const auto is_new = [&](const auto& change) {
        TerrainDocument changed = hill;
        change(changed.source);
        return !prepare_terrain(changed, folder / "cache").from_cache;
    };
    EXPECT_TRUE(is_new([](ElevationSource& s) { s.crs = "EPSG:32612"; }));
    EXPECT_TRUE(is_new([](ElevationSource& s) { s.no_data = 150.0; }));
    EXPECT_TRUE(is_new([](ElevationSource& s) { s.vertical_unit = "ft"; }));
    EXPECT_TRUE(is_new([](ElevationSource& s) { s.vertical_datum = VerticalDatum::Ellipsoid; }));
    EXPECT_FALSE(is_new([](ElevationSource&) {}));
}

TEST(PrepareScene, ReportsTheFilesAsTheyAreNamedNow) {
    const TemporaryFolder folder;
    static_cast<void>(prepare_terrain(write_hill(folder / "hill.asc", "100"), folder / "cache"));
    const PreparedTerrain again = prepare_terrain(write_hill(folder / "renamed.asc", "100"), folder / "cache");
    EXPECT_TRUE(again.from_cache);
    EXPECT_EQ(again.scene.report.files, std::vector{folder / "renamed.asc"});
}

TEST(PrepareScene, DoesWithoutACacheThatCannotBeWritten) {
    const TemporaryFolder folder;
    std::ofstream(folder / "no_folder") << "a file";
    const TerrainDocument hill = write_hill(folder / "hill.asc", "100");
    EXPECT_FALSE(prepare_terrain(hill, folder / "no_folder").from_cache);
    EXPECT_FALSE(prepare_terrain(hill, folder / "no_folder").from_cache);
}

TEST(PrepareScene, DoesNotTrustABrokenFileInTheCache) {
    const TemporaryFolder folder;
    const TerrainDocument hill = write_hill(folder / "hill.asc", "100");
    const PreparedTerrain first = prepare_terrain(hill, folder / "cache");
    const auto file = folder / "cache" / "scenes" / (first.scene.content_hash + ".scene");
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    const PreparedTerrain again = prepare_terrain(hill, folder / "cache");
    EXPECT_FALSE(again.from_cache);
    EXPECT_EQ(again.scene.mesh.positions, first.scene.mesh.positions);
}

TEST(PrepareScene, RefusesARasterWithoutAnyCell) {
    const TemporaryFolder folder;
    TerrainDocument row = write_hill(folder / "row.asc", "100");
    std::ofstream(folder / "row.asc")
        << "ncols 3\nnrows 3\nxllcorner 450000\nyllcorner 4150000\ncellsize 75\nNODATA_value -9999\n"
        << "100 -9999 100\n-9999 -9999 -9999\n100 -9999 100\n";
    try {
        static_cast<void>(prepare_terrain(row, folder / "cache"));
        FAIL() << "prepared";
    } catch (const UserError& error) {
        EXPECT_EQ(error.problems().front().text(),
                  (folder / "row.asc").string() +
                      ": no cell of the raster has three measured corners, so there is no ground");
    }
}

}  // namespace
}  // namespace overfly
