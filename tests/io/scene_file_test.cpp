#include "io/scene_file.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/sample_raster.h"
#include "io/temporary_folder.h"
#include "terrain/triangulate.h"

namespace overfly {
namespace {

PreparedScene small_scene() {
    PreparedScene scene;
    scene.content_hash = "0123";
    scene.origin = {Angle::degrees(-105.4), Angle::degrees(37.7), 12.5};
    scene.report.files = {"a.tif", "folder/b.tif"};
    scene.report.crs_name = "WGS 84";
    scene.report.no_data = -9999.0;
    scene.report.valid_count = 4;
    scene.report.vertical = {VerticalDatum::Offset, 3.5, "+3.5 m", Provenance::Stated};
    scene.report.extent = {1, 2, 3, 4};
    scene.mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}, {1, 1, 0.2}};
    scene.mesh.elevation_m = {1, 2, 3, 4};
    scene.mesh.samples = {{0, 1}, {1, 1}, {0, 0}, {1, 0}};
    scene.largest_error_px = 0.25;
    scene.mesh.triangles = {{0, 1, 2}, {1, 3, 2}};
    scene.mesh.twins = {{kNone, 6, kNone}, {kNone, kNone, 1}};
    return scene;
}

TEST(SceneFile, ComesBackToTheLastBit) {
    const TemporaryFolder folder;
    PreparedScene scene = small_scene();
    save_scene(folder / "a.scene", scene);
    EXPECT_EQ(load_scene(folder / "a.scene"), scene);
    EXPECT_EQ(scene_content_hash(folder / "a.scene"), "0123");
    EXPECT_EQ(folder.file_count(), 1U);

    scene.report.no_data.reset();
    scene.mesh = {};
    save_scene(folder / "a.scene", scene);  // replaces
    EXPECT_EQ(load_scene(folder / "a.scene"), scene);
}

TEST(SceneFile, HoldsARealMesh) {
    const TemporaryFolder folder;
    const ElevationFile elevation = read_elevation({.dem = {blanca()}});
    const SceneFrame frame(elevation.centre);
    const PreparedScene scene{"key", elevation.centre, elevation.report,
                              triangulate(*elevation.model, frame, elevation.locate)};
    save_scene(folder / "a.scene", scene);
    EXPECT_TRUE(load_scene(folder / "a.scene") == scene);
}

TEST(SceneFile, IsNothingWhenMissingOrForeign) {
    const TemporaryFolder folder;
    EXPECT_FALSE(load_scene(folder / "no.scene").has_value());
    EXPECT_FALSE(scene_content_hash(folder / "no.scene").has_value());
    std::ofstream(folder / "a.scene") << "hello";
    EXPECT_FALSE(load_scene(folder / "a.scene").has_value());
    EXPECT_FALSE(load_scene(folder.path()).has_value());
}

// Every byte of the file matters: none may be changed, cut off or added.
TEST(SceneFile, IsNothingWhenDamagedAnywhere) {
    const TemporaryFolder folder;
    save_scene(folder / "a.scene", small_scene());
    std::string bytes(std::filesystem::file_size(folder / "a.scene"), '\0');
    std::ifstream(folder / "a.scene", std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const auto loads = [&](const std::string& content) {
        std::ofstream(folder / "b.scene", std::ios::binary) << content;
        return load_scene(folder / "b.scene").has_value();
    };
    ASSERT_TRUE(loads(bytes));
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string damaged = bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x40);
        EXPECT_FALSE(loads(damaged)) << "byte " << i;
    }
    for (const std::size_t size : {bytes.size() - 1, bytes.size() / 2, std::size_t{50}, std::size_t{0}})
        EXPECT_FALSE(loads(bytes.substr(0, size))) << size;
    EXPECT_FALSE(loads(bytes + '\0'));
}

TEST(SceneFile, SaysWhenItCantBeWritten) {
    const TemporaryFolder folder;
    EXPECT_THROW(save_scene(folder / "no" / "a.scene", small_scene()), UserError);
}

}  // namespace
}  // namespace overfly
