#include <gtest/gtest.h>

#include <iostream>

#include "two_ways/frame_laws.h"

namespace overfly {
namespace {

using namespace testing;

constexpr PictureSize kSize = {160, 90};
constexpr TimeRange kExposure = half_a_frame(1.0);

// Lines that drift over a small picture of the dive.
class DriftingLines : public ::testing::Test {
  protected:
    [[nodiscard]] FrameMaker maker(double drift_px, TimeRange exposure = kExposure) const {
        FrameMaker make = plain_;
        make.exposure = exposure;
        make.drift_px = drift_px;
        return make;
    }

    SampleFlight flight_{diving_flight()};
    Sight sight_ = flight_.sight(kSize);
    FrameMaker plain_{flight_.stage, sight_, kSize, kExposure};  // the ground is lit once
};

void expect_covered(const Frame& frame) {
    for (const auto& pixel : frame.rgba) EXPECT_NEAR(pixel[3], 1.0F, 1e-5F);
}

TEST_F(DriftingLines, AreNearerToTheTruthThanLinesAtRest) {
    const Frame reference = maker(0.0).by_samples(1024);
    for (const int lines : {1, 2, 4}) {
        const Frame drifting = maker(8.0).by_kinetic_lines(lines);
        expect_covered(drifting);
        const double error = root_mean_square(drifting, reference);
        const double at_rest = root_mean_square(maker(0.0).by_kinetic_lines(lines), reference);
        const double sampled = root_mean_square(maker(0.0).by_samples(16 * lines), reference);
        std::cout << lines << " lines: RMSE " << error << ", at rest " << at_rest << ", " << 16 * lines << " samples "
                  << sampled << "\n";
        EXPECT_LT(error, 0.7 * at_rest);
        EXPECT_LT(error, sampled);
    }
}

TEST_F(DriftingLines, OfBothTracersMakeTheSamePicture) {
    expect_kinetic_lines_to_be_the_interval_tracers(maker(8.0), 2);
}

// Swept while the world stands still: against as many samples of the same instant as make a sharp edge smooth.
TEST_F(DriftingLines, MakeASharpFrameSmooth) {
    const TimeRange instant = {1.0, 1.0};
    const Frame reference = maker(0.0, instant).by_samples(1024);
    const Frame swept = maker(8.0, instant).by_kinetic_lines(2);
    expect_covered(swept);
    const double error = root_mean_square(swept, reference);
    const double sampled = root_mean_square(maker(0.0, instant).by_samples(16), reference);
    std::cout << "a sharp frame: 2 lines RMSE " << error << ", 16 samples " << sampled << "\n";
    EXPECT_LT(error, sampled);
}

// The ground is banded, harder than any landscape; its tiles get as many lines as it takes.
TEST_F(DriftingLines, ReachTheErrorThatIsAskedFor) {
    const Frame reference = maker(0.0).by_samples(1024);
    for (const double asked : {0.008, 0.004}) {
        FrameMaker make = maker(8.0);
        make.error = asked;
        const Frame frame = make.by_kinetic_lines(1);
        expect_covered(frame);
        const double error = root_mean_square(frame, reference);
        std::cout << "asked for an error of " << asked << ": RMSE " << error << "\n";
        EXPECT_LT(error, 1.25 * asked);
        EXPECT_GT(error, 0.2 * asked);
    }
}

// Straight ahead over ground that is drawn out sidewise, whichever way the camera is held. Lines that drift along it
// have three times the error of 64 samples.
TEST(DriftingLinesAhead, GoOverWhatIsDrawnOut) {
    constexpr PictureSize kSquare = {128, 128};
    for (const double roll_deg : {0.0, 90.0}) {
        ShareFlight flight = level_flight();
        for (ShareFlight::Key& k : flight.keys) k.attitude.roll = k.attitude.roll + Angle::degrees(roll_deg);
        const SampleFlight rolled(flight);
        const Sight sight = rolled.sight(kSquare);
        FrameMaker make = {rolled.stage, sight, kSquare, kExposure};
        const Frame reference = make.by_samples(1024);
        const double sampled = root_mean_square(make.by_samples(64), reference);
        make.drift_px = 8.0;
        const double error = root_mean_square(make.by_kinetic_lines(1), reference);
        std::cout << "rolled by " << roll_deg << " degrees: 1 line RMSE " << error << ", 64 samples " << sampled
                  << "\n";
        EXPECT_LT(error, 1.8 * sampled);
    }
}

TEST_F(DriftingLines, MakeTheSamePixelsForAnyNumberOfThreads) {
    expect_the_same_for_any_number_of_threads([&] { return maker(8.0).by_kinetic_lines(2); });
}

TEST_F(DriftingLines, MakeAFrameTheSameWhicheverOthersAreAskedFor) {
    expect_the_same_whichever_frames_are_asked_for(
        1.0, [&](const std::vector<TimeRange>& asked, const std::vector<TimeRange>& all) {
            return maker(8.0).expose_some(TracerKind::Kinetic, 2, 1, asked, all);
        });
}

// Twenty times the frame rate: so many frames in a piece that lines which drift are swept in several stretches of it,
// and lines at rest set out several times.
TEST_F(DriftingLines, OfAHighFrameRateMakeAFrameTheSameWhicheverOthersAreAskedFor) {
    constexpr double kFrame_s = 1.0 / 480.0;
    const PictureSize size = {32, 18};
    const Sight sight = flight_.sight(size, 1.0 / 3.0);
    std::vector<TimeRange> all, asked;
    for (int k = 0; k < 160; ++k) all.push_back({1.0 + k * kFrame_s, 1.0 + (k + 0.5) * kFrame_s});
    const std::vector<std::size_t> numbers = {3, 50, 127, 128, 129, 159};
    for (const std::size_t k : numbers) asked.push_back(all[k]);
    FrameMaker make = {flight_.stage, sight, size, kExposure};
    for (const double drift_px : {0.0, 8.0}) {
        make.drift_px = drift_px;
        const std::vector<Frame> every = make.expose_some(TracerKind::Kinetic, 1, 1, all, all);
        const std::vector<Frame> some = make.expose_some(TracerKind::Kinetic, 1, 1, asked, all);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            expect_covered(some[i]);
            EXPECT_TRUE(some[i] == every[numbers[i]]) << numbers[i] << ", drift " << drift_px;
        }
    }
}

}  // namespace
}  // namespace overfly
