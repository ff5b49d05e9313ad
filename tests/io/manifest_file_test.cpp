#include "io/manifest_file.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

Manifest sample_manifest() {
    ManifestFrame first{.number = 7,
                        .file = "demo.0007.exr",
                        .time_s = 1.0 / 3.0,
                        .size_bytes = std::uint64_t{5} << 32,
                        .pixels_sha256 = std::string(64, 'a'),
                        .statistics = {FrameStatistics::Luminance{0.0, 0.25, 12.5}, 0.5, 123.25},
                        .render_s = 2.5};
    ManifestFrame bare{.number = 9, .file = "demo.0009.exr", .pixels_sha256 = "", .statistics = {}, .render_s = {}};
    ManifestSequence demo;
    demo.software = "overfly 0.1.0";
    demo.libraries = {{"GDAL", "3.6.2"}, {"OpenEXR", "3.1.5"}};
    demo.command = {"overfly", "render", "a \"quoted\" name.yaml"};
    demo.inputs = std::string(64, 'b');
    demo.files = {{"shot", "../demo.yaml", std::string(64, 'c')}, {"elevation", "/vsizip/a.zip/b.tif", "d"}};
    demo.crs = "WGS 84 / UTM zone 13N (EPSG:32613)";
    demo.vertical_datum = "EGM96 geoid (stated)";
    demo.scene_origin = {Angle::degrees(-105.25), Angle::degrees(37.5), 0.0};
    demo.width = 960;
    demo.height = 540;
    demo.rate = {24000, 1001};
    demo.first = 7;
    demo.count = 3;
    demo.sampling = {"kinetic", 2, 64, 8.0, 0.001};
    demo.mesh = {0.5, 0.4375};
    demo.motion = {0.01, std::nullopt};
    demo.layer_files = {Layer::Normal, Layer::Id};
    demo.frames = {first, bare};
    Manifest manifest;
    manifest.sequences["demo"] = demo;
    manifest.sequences["empty"] = {};
    return manifest;
}

TEST(ManifestFile, GivesBackWhatWasWritten) {
    const TemporaryFolder folder;
    const Manifest manifest = sample_manifest();
    write_manifest(folder.path(), manifest);
    const auto back = read_manifest(folder.path());
    ASSERT_TRUE(back);
    // Degrees become radians on the way.
    Manifest expected = manifest;
    Geodetic& origin = expected.sequences["demo"].scene_origin;
    EXPECT_NEAR(back->sequences.at("demo").scene_origin.lon.degrees(), -105.25, 1e-12);
    origin = back->sequences.at("demo").scene_origin;
    EXPECT_EQ(*back, expected);
    EXPECT_EQ(folder.file_count(), 1U);
}

TEST(ManifestFile, FindsItsFramesByNumber) {
    const Manifest manifest = sample_manifest();
    const ManifestSequence& demo = manifest.sequences.at("demo");
    EXPECT_EQ(demo.find(7), &demo.frames[0]);
    EXPECT_EQ(demo.find(9), &demo.frames[1]);
    for (const int absent : {6, 8, 10}) EXPECT_EQ(demo.find(absent), nullptr);
}

TEST(ManifestFile, IsNothingWhereThereIsNone) {
    const TemporaryFolder folder;
    EXPECT_FALSE(read_manifest(folder.path()));
}

TEST(ManifestFile, RefusesWhatIsNoManifest) {
    const TemporaryFolder folder;
    write_manifest(folder.path(), sample_manifest());
    std::ifstream stream(folder / kManifestName);
    const std::string whole{std::istreambuf_iterator<char>(stream), {}};
    std::string later = whole;
    later.replace(later.find("\"version\": 1"), 12, "\"version\": 2");
    for (const std::string& text :
         {std::string(), std::string("{}"), std::string("[1, 2]"),
          std::string(R"({"format": "overfly manifest", "version": 1})"), whole.substr(0, whole.size() / 2), later}) {
        std::ofstream(folder / kManifestName) << text;
        EXPECT_THROW((void)read_manifest(folder.path()), UserError) << text.substr(0, 100);
    }
}

TEST(ManifestFile, NamesTheFileThatCanNotBeWritten) {
    const TemporaryFolder folder;
    try {
        write_manifest(folder / "absent", sample_manifest());
        FAIL() << "there is no such folder";
    } catch (const UserError& error) {
        EXPECT_EQ(error.problems().front().place.file, folder / "absent" / kManifestName);
    }
}

}  // namespace
}  // namespace overfly
