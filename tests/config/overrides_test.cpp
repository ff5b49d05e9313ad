#include "config/overrides.h"

#include <gtest/gtest.h>

#include "config/read.h"
#include "config/sample_documents.h"

namespace overfly {
namespace {

using namespace config_tests;
using Texts = std::vector<std::string>;

ShotDocument shot_with(const Texts& overrides) { return read_shot_document(good_folder / "shot.yaml", overrides); }
std::string refusal(const Texts& overrides) {
    return error_text([&] { (void)shot_with(overrides); });
}

TEST(Overrides, ReplaceAndAddValues) {
    const ShotDocument shot = shot_with({"image.width=1280", "look.sun.elevation_deg=5", "frames={first: 7}"});
    EXPECT_EQ(shot.image.width, 1280);
    EXPECT_EQ(shot.image.height, 360);
    EXPECT_EQ(shot.look.look.sun_elevation, Angle::degrees(5));
    EXPECT_EQ(shot.frames.first, 7);
    EXPECT_EQ(shot.frames.count, std::nullopt);
    const ShotDocument smallest =
        read_shot_document(good_folder / "smallest_shot.yaml", Texts{"look.sun.azimuth_deg=90", "output.name=a=b"});
    EXPECT_EQ(smallest.look.look.sun_azimuth, Angle::degrees(90));
    EXPECT_EQ(smallest.output.name, "a=b");
}

TEST(Overrides, OfOneKeyTheLastCounts) { EXPECT_EQ(shot_with({"image.width=1", "image.width=2"}).image.width, 2); }

TEST(Overrides, ReachIntoTheFlightAndTheTerrain) {
    const ShotDocument shot = shot_with({"flight.keyframes.0.time_s=1", "terrain.band=2", "flight.lens.hfov_deg=30"});
    EXPECT_EQ(shot.flight.keyframes[0].time_s, 1.0);
    EXPECT_EQ(shot.flight.keyframes[0].lens.horizontal_fov, Angle::degrees(30));
    EXPECT_EQ(shot.terrain.source.band, 2);
}

TEST(Overrides, OfPathsAreFromTheWorkingFolder) {
    const TemporaryFolder folder;
    const auto dem = folder.write("other.tif", "");
    const auto terrain = folder.write("other.yaml", "dem: other.tif\n");
    const auto here = std::filesystem::relative(terrain);
    const ShotDocument shot = shot_with({"terrain=" + here.string(), "output.folder=frames"});
    EXPECT_EQ(shot.terrain.file, here);
    EXPECT_TRUE(std::filesystem::equivalent(shot.terrain.source.dem.at(0), dem));
    EXPECT_EQ(shot.output.folder, "frames");
}

TEST(Overrides, WorkOnTerrainAndFlightAlone) {
    EXPECT_EQ(read_terrain_document(good_folder / "terrain.yaml", Texts{"crs=EPSG:4326"}).source.crs, "EPSG:4326");
    EXPECT_EQ(read_flight_document(good_folder / "flight.yaml", Texts{"keyframes.2.time_s=9"}).keyframes[2].time_s, 9);
}

TEST(Overrides, AreReportedAsTheyWereGiven) {
    EXPECT_EQ(refusal({"image.widht=480"}),
              "--set image.widht=480: unknown key 'widht' in 'image'; did you mean 'width'? known: width, height, "
              "transparent_sky, filter, filter_width_px");
    EXPECT_EQ(refusal({"image.width=0"}), "--set image.width=0: image.width: got 0, allowed 1 to 65536");
    EXPECT_EQ(refusal({"image=5"}), "--set image=5: image: got 5, allowed a mapping (`key: value` lines)");
    EXPECT_EQ(refusal({"flight.keyframes.0.time_s=soon"}),
              "--set flight.keyframes.0.time_s=soon: keyframes.0.time_s: got 'soon', allowed a number, -1000000 to "
              "1000000");
    EXPECT_EQ(refusal({"terrain.vertical_datum=ellipsiod"}),
              "--set terrain.vertical_datum=ellipsiod: vertical_datum: got 'ellipsiod', allowed egm96, sea_level, "
              "ellipsoid or offset; did you mean 'ellipsoid'?\n" +
                  (good_folder / "terrain.yaml").string() +
                  ":10:20: vertical_offset_m: got -16.5, allowed only with `vertical_datum: offset`");
}

TEST(Overrides, MustHaveAKeyAndAValue) {
    for (const std::string text : {"", "image.width", "=5", ".width=5", "image.=5", "image..width=5"}) {
        EXPECT_EQ(refusal({text}), "--set " + text + ": got no key and value, allowed key.subkey=value");
    }
    EXPECT_EQ(refusal({"a\nb"}), "--set a?b: got no key and value, allowed key.subkey=value");
    EXPECT_EQ(refusal({"image=[1"}), "--set image=[1: broken YAML: end of sequence flow not found");
}

TEST(Overrides, MustLeadSomewhere) {
    EXPECT_EQ(refusal({"flight.keyframes.3.time_s=1"}),
              "--set flight.keyframes.3.time_s=1: keyframes: got item '3', allowed 0 to 2");
    EXPECT_EQ(refusal({"flight.keyframes.first.time_s=1"}),
              "--set flight.keyframes.first.time_s=1: keyframes: got item 'first', allowed 0 to 2");
    EXPECT_EQ(refusal({"image.width.px=1"}),
              "--set image.width.px=1: image.width: got 'px' inside of 640, allowed nothing inside of a plain value");
}

TEST(Overrides, AreAllCheckedAtOnce) {
    EXPECT_EQ(refusal({"image.width=0", "nonsense", "shutter.angle_deg=-1"}),
              "--set nonsense: got no key and value, allowed key.subkey=value\n"
              "--set image.width=0: image.width: got 0, allowed 1 to 65536\n"
              "--set shutter.angle_deg=-1: shutter.angle_deg: got -1, allowed 0 to 360");
}

}  // namespace
}  // namespace overfly
