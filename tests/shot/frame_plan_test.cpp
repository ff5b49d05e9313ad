#include "shot/frame_plan.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace overfly {
namespace {

ShotDocument shot_of(FramesDocument frames) {
    ShotDocument shot;
    shot.file = "shot.yaml";
    shot.frames = frames;
    shot.output.folder = "out";
    shot.output.name = "dive";
    return shot;
}

std::size_t count_of(FramesDocument frames, double flight_s) {
    return plan_frames(shot_of(frames), {0.0, flight_s}).size();
}

TEST(FramePlan, HasTheFramesThatBeginBeforeTheFlightEnds) {
    EXPECT_EQ(count_of({}, 4.0), 96U);
    EXPECT_EQ(count_of({}, 4.01), 97U);
    EXPECT_EQ(count_of({1, {}, {30000, 1001}, 0.0}, 1001.0 / 1000.0), 30U);
    EXPECT_EQ(count_of({1, {}, {}, 3.5}, 4.0), 12U);
    EXPECT_EQ(count_of({1, 7, {}, 0.0}, 4.0), 7U);
}

// Durations that are a whole number of frames in decimal, but not in binary.
TEST(FramePlan, DoesNotAddAFrameForARounding) {
    for (int tenths = 1; tenths <= 200; ++tenths) {
        const auto frames = static_cast<std::size_t>(tenths);
        EXPECT_EQ(count_of({1, {}, {10, 1}, 0.0}, tenths * 0.1), frames) << tenths;
        EXPECT_EQ(count_of({1, {}, {10, 1}, 0.1}, (tenths + 1) * 0.1), frames) << tenths;
    }
}

TEST(FramePlan, AFlightWithoutDurationHasOneFrame) { EXPECT_EQ(count_of({}, 0.0), 1U); }

TEST(FramePlan, RefusesAStartAfterTheFlight) {
    try {
        static_cast<void>(plan_frames(shot_of({1, {}, {}, 5.0}), {0.0, 4.0}));
        FAIL() << "planned";
    } catch (const UserError& error) {
        EXPECT_EQ(error.problems().front().text(),
                  "shot.yaml: frames.start_s: got 5, but the flight lasts 4.000 s; no frame is left");
    }
}

TEST(FramePlan, FramesAreWhereTheRateAndTheStartPutThem) {
    const auto frames = plan_frames(shot_of({1001, {}, {24000, 1001}, 0.5}), {2.0, 6.0});
    ASSERT_GT(frames.size(), 24U);
    EXPECT_EQ(frames[0].number, 1001);
    EXPECT_EQ(frames[0].time_s, 2.5);
    EXPECT_EQ(frames[24].number, 1025);
    EXPECT_DOUBLE_EQ(frames[24].time_s, 2.5 + 1.001);
    EXPECT_EQ(frames[24].file, "out/dive.1025.exr");
}

TEST(FramePlan, TheShutterOpensAroundTheFramesTime) {
    ShotDocument shot = shot_of({1, 3, {}, 0.0});
    shot.shutter.angle = Angle::degrees(90.0);
    const auto frames = plan_frames(shot, {0.0, 1.0});
    const double quarter_s = 0.25 / 24.0;
    EXPECT_DOUBLE_EQ(frames[1].exposure.begin_s, 1.0 / 24.0 - 0.5 * quarter_s);
    EXPECT_DOUBLE_EQ(frames[1].exposure.end_s, 1.0 / 24.0 + 0.5 * quarter_s);
    const TimeRange all = exposed_times(frames);
    EXPECT_EQ(all.begin_s, frames[0].exposure.begin_s);
    EXPECT_EQ(all.end_s, frames[2].exposure.end_s);
}

TEST(FramePlan, NumbersHaveFourDigitsAndMoreWhereTheyNeedMore) {
    EXPECT_EQ(frame_file_name("a", 7), "a.0007.exr");
    EXPECT_EQ(frame_file_name("a", 12345), "a.12345.exr");
}

}  // namespace
}  // namespace overfly
