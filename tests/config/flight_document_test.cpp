#include <gtest/gtest.h>

#include "config/read.h"
#include "config/sample_documents.h"

namespace overfly {
namespace {

using namespace config_tests;

TEST(ReadFlightDocument, ReadsEveryKey) {
    const FlightDocument flight = read_flight_document(good_folder / "flight.yaml");
    ASSERT_EQ(flight.keyframes.size(), 3U);

    const Lens wide{Angle::degrees(60), 24.89};
    const Keyframe first{
        .time_s = 0.0,
        .place = {Angle::degrees(-105.60), Angle::degrees(37.55), 4800.0, HeightAbove::SeaLevel},
        .aim = LookAt{{Angle::degrees(-105.4856), Angle::degrees(37.5775), 4374.0, HeightAbove::Ellipsoid}, {}},
        .lens = wide};
    EXPECT_EQ(flight.keyframes[0], first);

    const Keyframe second{.time_s = 2.5,
                          .place = {Angle::degrees(-105.55), Angle::degrees(37.50), 600.0, HeightAbove::Ground},
                          .aim = Attitude{Angle::degrees(20), Angle::degrees(-10.5), Angle::degrees(5)},
                          .lens = Lens::of_focal_length(35.0, 24.89)};
    EXPECT_EQ(flight.keyframes[1], second);

    const Keyframe third{
        .time_s = 6.0,
        .place = {Angle::degrees(-105.45), Angle::degrees(37.52), 4900.0, HeightAbove::SeaLevel},
        .aim = LookAt{{Angle::degrees(-105.49), Angle::degrees(37.58), 0.0, HeightAbove::Ground}, Angle::degrees(-2)},
        .lens = {Angle::degrees(40), 24.89}};
    EXPECT_EQ(flight.keyframes[2], third);
}

TEST(ReadFlightDocument, SaysWhereEachKeyframeStands) {
    const FlightDocument flight = read_flight_document(good_folder / "flight.yaml");
    ASSERT_EQ(flight.places.size(), 3U);
    const std::string file = (good_folder / "flight.yaml").string();
    EXPECT_EQ(flight.places[0].text(), file + ":7:5");
    EXPECT_EQ(flight.places[1].text(), file + ":8:5");
    EXPECT_EQ(flight.places[2].text(), file + ":17:5");
}

TEST(ReadFlightDocument, CountsHeightsFromSeaLevelUnlessToldOtherwise) {
    const TemporaryFolder folder;
    const std::string keyframes =
        "keyframes: [{time_s: 0, lon_deg: 0, lat_deg: 0, height_m: 1, heading_deg: 0, pitch_deg: 0}]\n";
    const FlightDocument plain = read_flight_document(folder.write("a.yaml", keyframes));
    EXPECT_EQ(plain.keyframes[0].place.above, HeightAbove::SeaLevel);
    EXPECT_EQ(plain.keyframes[0].lens, Lens{});
    // The flight's own words count wherever they stand.
    const FlightDocument above_ground =
        read_flight_document(folder.write("b.yaml", keyframes + "lens: {focal_length_mm: 50}\nheight_above: ground\n"));
    EXPECT_EQ(above_ground.keyframes[0].place.above, HeightAbove::Ground);
    EXPECT_EQ(above_ground.keyframes[0].lens, Lens::of_focal_length(50.0, 36.0));
}

TEST(ReadFlightDocument, TakesOnlyTheSensorFromALensWithoutOptics) {
    const TemporaryFolder folder;
    const FlightDocument flight = read_flight_document(
        folder.write("a.yaml",
                     "lens: {hfov_deg: 40, sensor_width_mm: 20}\n"
                     "keyframes:\n"
                     "  - {time_s: 0, lon_deg: 0, lat_deg: 0, height_m: 1, heading_deg: 0, pitch_deg: 0,\n"
                     "     lens: {sensor_width_mm: 30}}\n"));
    EXPECT_EQ(flight.keyframes[0].lens, (Lens{Angle::degrees(40), 30.0}));
}

TEST(ReadFlightDocument, ExpandsAliases) {
    const TemporaryFolder folder;
    const FlightDocument flight = read_flight_document(
        folder.write("a.yaml",
                     "keyframes:\n"
                     "  - {time_s: 0, lon_deg: 0, lat_deg: 0, height_m: 1, look_at: &peak {lon_deg: 1, lat_deg: 1, "
                     "height_m: 2}}\n"
                     "  - {time_s: 1, lon_deg: 0, lat_deg: 0, height_m: 1, look_at: *peak}\n"));
    EXPECT_EQ(flight.keyframes[0].aim, flight.keyframes[1].aim);
}

}  // namespace
}  // namespace overfly
