#include "shot/flight_notes.h"

#include <gtest/gtest.h>

#include "shot/sample_shot.h"

namespace overfly {
namespace {

// The sample flight of two seconds 5000 m above a sea level that is the ellipsoid, over ground as high as is said.
std::vector<std::string> notes_over(double ground_m, std::optional<int> count) {
    const TemporaryFolder folder;
    ShotDocument shot = sample_shot(folder.path());
    shot.frames.count = count;
    const Surroundings surroundings = {[=](Angle, Angle) { return ground_m; }, [](Angle, Angle) { return 0.0; },
                                       [](Point<Scene>) { return 1000.0; }};
    const CameraPath path(shot.flight.keyframes, SceneFrame({Angle::degrees(-105.5), Angle::degrees(37.6), 0.0}),
                          surroundings);
    return flight_notes(plan_frames(shot, path.times()), path, surroundings);
}

TEST(FlightNotes, SayNothingOfAnOrdinaryFlight) { EXPECT_TRUE(notes_over(3000.0, std::nullopt).empty()); }

TEST(FlightNotes, TellOfFramesBelowTheGround) {
    EXPECT_EQ(notes_over(6000.0, std::nullopt),
              std::vector<std::string>{"note: in 48 of 48 frames, the first is 1, the camera is below the ground"});
}

TEST(FlightNotes, TellOfFramesAfterTheLastKeyframe) {
    EXPECT_TRUE(notes_over(3000.0, 49).empty()) << "frame 49 is at the last keyframe";
    EXPECT_EQ(notes_over(3000.0, 60),
              std::vector<std::string>{"note: in 11 of 60 frames, the first is 50, the flight of 2.000 s has not begun "
                                       "or is over, and the camera goes straight on"});
}

}  // namespace
}  // namespace overfly
