#include "io/frame_facts.h"

#include <array>
#include <cmath>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "flight/attitude.h"
#include "geo/scene_frame.h"
#include "io/sample_frame.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

TEST(FrameFacts, AreWhatTheHeaderWasWrittenFrom) {
    const TemporaryFolder folder;
    const FrameHeader header = sample_header();
    write_frame(folder / "a.exr", sample_frame(48, 27), header);
    const FrameFacts facts = read_frame_facts(folder / "a.exr");
    EXPECT_EQ(facts.width, 48);
    EXPECT_EQ(facts.height, 27);
    EXPECT_EQ(facts.number, 25);
    EXPECT_EQ(facts.time_s, 1.0);
    EXPECT_EQ(facts.rate, header.rate);
    EXPECT_EQ(facts.capture_rate, header.capture_rate);
    EXPECT_EQ(facts.time_code, smpte_time(25, header.rate));
    EXPECT_EQ(facts.date, "2026-06-21T23:59:59.750000-06:00");
    EXPECT_EQ(facts.world_to_camera, exr_world_to_camera(header.camera));
    EXPECT_EQ(facts.screen_window_width, 1.5);
    EXPECT_EQ(facts.focal_length_mm, 24.0);
    EXPECT_NEAR(facts.camera_place->lon.degrees(), -105.4, 1e-12);
    EXPECT_EQ(facts.altitude_m, 4500.0);
    EXPECT_EQ(facts.shot, header.shot);
    EXPECT_EQ(facts.flight, header.flight);
    EXPECT_EQ(facts.software, header.software);
}

TEST(FrameFacts, AreFewOfAnotherProgramsPicture) {
    const TemporaryFolder folder;
    Imf::Header header(8, 4);
    header.channels().insert("R", Imf::Channel(Imf::HALF));
    {
        Imf::OutputFile output((folder / "a.exr").c_str(), header);  // without a line of pixels
    }
    const FrameFacts facts = read_frame_facts(folder / "a.exr");
    EXPECT_EQ(facts.width, 8);
    EXPECT_FALSE(facts.number || facts.time_s || facts.rate || facts.world_to_camera || facts.camera_place);
    EXPECT_FALSE(camera_attitude(facts));
    EXPECT_EQ(facts.inputs, "");
    EXPECT_THROW((void)read_frame_facts(folder / "absent.exr"), UserError);
}

TEST(FrameFacts, TellTheAttitudeThatTheCameraWasGiven) {
    const TemporaryFolder folder;
    FrameHeader header = sample_header();
    const SceneFrame frame(header.scene_origin);
    for (const auto& [heading_deg, pitch_deg, roll_deg] :
         {std::array{0.0, 0.0, 0.0}, {140.0, -12.0, 0.0}, {359.5, 40.0, -30.0}, {200.0, -85.0, 175.0}}) {
        const Attitude given{Angle::degrees(heading_deg), Angle::degrees(pitch_deg), Angle::degrees(roll_deg)};
        header.camera.orientation = orientation(given, frame.local_axes(header.camera_place));
        write_frame(folder / "a.exr", sample_frame(4, 2), header);
        const auto found = camera_attitude(read_frame_facts(folder / "a.exr"));
        ASSERT_TRUE(found);
        EXPECT_NEAR(std::remainder(found->heading.degrees() - heading_deg, 360.0), 0.0, 1e-9);
        EXPECT_NEAR(found->pitch.degrees(), pitch_deg, 1e-9);
        EXPECT_NEAR(found->roll.degrees(), roll_deg, 1e-9);
        EXPECT_GE(found->heading.degrees(), 0.0);
    }
}

}  // namespace
}  // namespace overfly
