#include "flight/flight_clock.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

constexpr FrameRate kNtsc = {24000, 1001};

TEST(FlightClock, WithoutSpeedsIsTheFrameRate) {
    const FlightClock clock(kNtsc, 1001, 0.5, {});
    EXPECT_TRUE(clock.is_even());
    for (int k = 0; k < 200'000; k += 777) EXPECT_EQ(clock.time_s(1001 + k), 0.5 + kNtsc.time_s(k));
}

TEST(FlightClock, OneSpeedStretchesTime) {
    const FlightClock clock({24, 1}, 1, 2.0, {{0.0, 0.25}});
    EXPECT_TRUE(clock.is_even());
    EXPECT_DOUBLE_EQ(clock.time_s(1), 2.0);
    EXPECT_DOUBLE_EQ(clock.time_s(97), 3.0);
    EXPECT_DOUBLE_EQ(clock.time_s(0.0), 2.0 - 0.25 / 24.0);
}

// 24 frames at 1, then 24 in which it falls to 1/4, then on at that.
TEST(FlightClock, ChangingSpeedsAreIntegrated) {
    const FlightClock clock({24, 1}, 1, 0.0, {{25, 1.0}, {49, 0.25}});
    EXPECT_FALSE(clock.is_even());
    EXPECT_DOUBLE_EQ(clock.time_s(1), 0.0);
    EXPECT_DOUBLE_EQ(clock.time_s(25), 1.0);
    EXPECT_DOUBLE_EQ(clock.time_s(37), 1.0 + 0.5 * (1.0 + 0.625) / 2.0);
    EXPECT_DOUBLE_EQ(clock.time_s(49), 1.0 + 0.625);
    EXPECT_DOUBLE_EQ(clock.time_s(73), 1.0 + 0.625 + 0.25);
}

// Time goes on by the speed of the moment, for any frames, before the first too.
TEST(FlightClock, GoesOnByTheSpeed) {
    const std::vector<FlightSpeed> speeds = {{10.0, 2.0}, {12.5, 0.1}, {40.0, 0.1}, {50.0, 3.0}};
    const auto speed_at = [&](double frame) {
        if (frame <= speeds.front().frame) return speeds.front().speed;
        for (std::size_t i = 0; i + 1 < speeds.size(); ++i) {
            const double part = (frame - speeds[i].frame) / (speeds[i + 1].frame - speeds[i].frame);
            if (part <= 1.0) return speeds[i].speed + part * (speeds[i + 1].speed - speeds[i].speed);
        }
        return speeds.back().speed;
    };
    const FlightClock clock({25, 1}, 20, 1.0, speeds);
    EXPECT_DOUBLE_EQ(clock.time_s(20), 1.0);
    constexpr double kStep = 1e-4;
    for (double frame = -5.0; frame < 60.0; frame += 0.0917) {
        const double rise_s = clock.time_s(frame + kStep) - clock.time_s(frame - kStep);
        EXPECT_NEAR(rise_s * 25.0 / (2.0 * kStep), speed_at(frame), 1e-3) << frame;
    }
}

}  // namespace
}  // namespace overfly
