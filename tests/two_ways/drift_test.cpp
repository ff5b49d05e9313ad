#include <gtest/gtest.h>

#include <iostream>

#include "core/parallel.h"
#include "two_ways/blurred_frame.h"

namespace overfly {
namespace {

using namespace testing;

constexpr PictureSize kSize = {160, 90};
constexpr TimeRange kExposure = {1.0, 1.0 + 1.0 / 48.0};

// Lines that drift over a small picture of the dive.
class DriftingLines : public ::testing::Test {
  protected:
    DriftingLines() {
        PreparedTerrain blanca = prepared(OVERFLY_SOURCE_DIR "/terrain/blanca_peak_utm13n_75m.tif");
        const FlightDocument flight = flight_over(blanca.scene.report, diving_flight());
        stage_.emplace(std::move(blanca), middle_of(flight));
        sight_ = sight_of(motion_over(flight, *stage_, {0.01, kSize.width, kSize.height, 1.0 / 6.0}));
    }
    [[nodiscard]] FrameMaker maker(double drift_px, TimeRange exposure = kExposure) const {
        FrameMaker make = {*stage_, sight_, kSize, exposure};
        make.drift_px = drift_px;
        return make;
    }

    std::optional<Stage> stage_;
    Sight sight_;
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
    EXPECT_LT(root_mean_square(maker(8.0).by_kinetic_lines(2), maker(8.0).by_lines(2)), 1e-3);
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

TEST_F(DriftingLines, MakeTheSamePixelsForAnyNumberOfThreads) {
    const int before = thread_limit();
    limit_threads(1);
    const Frame one = maker(8.0).by_kinetic_lines(2);
    limit_threads(2);
    const Frame two = maker(8.0).by_kinetic_lines(2);
    limit_threads(before);
    EXPECT_TRUE(one == two);
}

TEST_F(DriftingLines, MakeAFrameTheSameWhicheverOthersAreAskedFor) {
    std::vector<TimeRange> exposures;
    for (int k = 0; k < 5; ++k) exposures.push_back({1.0 + k / 24.0, 1.0 + k / 24.0 + 1.0 / 48.0});
    const auto frames_of = [&](const std::vector<TimeRange>& asked) {
        return maker(8.0).expose_some(TracerKind::Kinetic, 2, 1, asked, exposures);
    };
    const std::vector<Frame> all = frames_of(exposures);
    EXPECT_TRUE(frames_of({exposures[0]}).front() == all[0]);
    const std::vector<Frame> some = frames_of({exposures[1], exposures[4]});
    EXPECT_TRUE(some[0] == all[1]);
    EXPECT_TRUE(some[1] == all[4]);
}

}  // namespace
}  // namespace overfly
