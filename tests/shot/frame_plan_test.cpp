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

TEST(FramePlan, SecondsAreTheFlights) {
    ShotDocument shot = shot_of({1, 3, {}, 0.0, {}, {{0.0, 0.5}}});
    shot.shutter.seconds = 0.01;
    shot.shutter.phase = Shutter::Phase::Start;
    const auto frames = plan_frames(shot, {0.0, 1.0});
    EXPECT_DOUBLE_EQ(frames[1].exposure.begin_s, 0.5 / 24.0);
    EXPECT_DOUBLE_EQ(frames[1].exposure.duration_s(), 0.01);
}

TEST(FramePlan, RefusesAnExposureThatLastsUntilTheNext) {
    ShotDocument shot = shot_of({1, 3, {}, 0.0, {}, {{2.0, 1.0}, {3.0, 0.5}}});
    shot.shutter.seconds = 1.0 / 24.0;
    try {
        static_cast<void>(plan_frames(shot, {0.0, 1.0}));
        FAIL() << "planned";
    } catch (const UserError& error) {
        EXPECT_EQ(error.problems().front().text(),
                  "shot.yaml: shutter.seconds: got 0.041666666666666664, but frame 2 lasts 0.031250 s of the flight");
    }
    shot.frames.count = 1;  // the only frame may be as long as one likes
    EXPECT_EQ(plan_frames(shot, {0.0, 1.0}).size(), 1U);
}

// Slow motion has more frames of the same flight, each exposed for as much less of it.
TEST(FramePlan, SlowMotionHasMoreFrames) {
    const ShotDocument slow = shot_of({1, {}, {}, 0.0, {}, {{0.0, 0.25}}});
    const auto frames = plan_frames(slow, {0.0, 4.0});
    EXPECT_EQ(frames.size(), 384U);
    EXPECT_DOUBLE_EQ(frames[4].time_s, 1.0 / 24.0);
    EXPECT_NEAR(frames[4].exposure.duration_s(), 0.125 / 24.0, 1e-15);
    EXPECT_NEAR(frames[4].exposure.centre_s(), frames[4].time_s, 1e-15);
    EXPECT_EQ(count_of({1, {}, {}, 0.0, {}, {{0.0, 2.0}}}, 4.0), 48U);
    // A second at 1, then slower and slower, 0.625 s in 24 frames, then 96 frames a second.
    EXPECT_EQ(count_of({1, {}, {}, 0.0, {}, {{25.0, 1.0}, {49.0, 0.25}}}, 1.625), 48U);
    EXPECT_EQ(count_of({1, {}, {}, 0.0, {}, {{25.0, 1.0}, {49.0, 0.25}}}, 2.625), 144U);
}

// Whatever the speeds.
TEST(FramePlan, ExposuresOf360DegreesLeaveNoGap) {
    for (const std::vector<FlightSpeed>& speeds :
         {std::vector<FlightSpeed>{}, {{0.0, 0.3}}, {{5.0, 1.0}, {20.0, 0.1}, {30.0, 2.5}}}) {
        for (const auto phase : {Shutter::Phase::Start, Shutter::Phase::Centre, Shutter::Phase::End}) {
            ShotDocument shot = shot_of({1, 40, {24000, 1001}, 0.5, {}, speeds});
            shot.shutter.angle = Angle::degrees(360.0);
            shot.shutter.phase = phase;
            const auto frames = plan_frames(shot, {0.0, 10.0});
            for (std::size_t k = 0; k + 1 < frames.size(); ++k) {
                EXPECT_NEAR(frames[k].exposure.end_s, frames[k + 1].exposure.begin_s, 1e-14);
                EXPECT_NEAR(frames[k].time_s + frames[k].lasts_s, frames[k + 1].time_s, 1e-14);
            }
        }
    }
}

// Two frames of a shot, and one of the same flight at half the rate.
TEST(FramePlan, TwoFramesAre360DegreesOfHalfTheRate) {
    ShotDocument shot = shot_of({1, 8, {24, 1}, 0.0});
    shot.shutter.angle = Angle::degrees(360.0);
    shot.shutter.phase = Shutter::Phase::Start;
    const auto frames = plan_frames(shot, {0.0, 4.0});
    shot.frames.rate = {12, 1};
    const auto half = plan_frames(shot, {0.0, 4.0});
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_DOUBLE_EQ(half[k].exposure.begin_s, frames[2 * k].exposure.begin_s);
        EXPECT_DOUBLE_EQ(half[k].exposure.end_s, frames[2 * k + 1].exposure.end_s);
    }
}

TEST(FramePlan, NumbersHaveFourDigitsAndMoreWhereTheyNeedMore) {
    EXPECT_EQ(frame_file_name("a", 7), "a.0007.exr");
    EXPECT_EQ(frame_file_name("a", 12345), "a.12345.exr");
}

}  // namespace
}  // namespace overfly
