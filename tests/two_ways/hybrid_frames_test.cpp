#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "two_ways/frame_laws.h"

namespace overfly {
namespace {

using namespace testing;

// A fast pan low over the ground: it rushes past in front, and stands nearly still far away.
ShareFlight panning_flight() {
    return {{{0.0, 0.35, 0.30, 0.01, attitude(20, -8, 0)}, {1.0, 0.36, 0.31, 0.01, attitude(110, -8, 0)}}};
}

class HybridFrames : public ::testing::Test {
  protected:
    [[nodiscard]] FrameMaker maker() const { return plain_; }
    [[nodiscard]] Frame by_both() const { return maker().expose(TracerKind::Hybrid, kLines, kSamples); }

    // How many of the picture's tiles are followed.
    [[nodiscard]] std::size_t tiles_by_lines() const {
        const FrameMaker make = maker();
        ShotDocument shot;
        shot.sampling.tracer = TracerKind::Hybrid;
        shot.sampling.lines = kLines;
        shot.sampling.samples = kSamples;
        const ShotTracers tracers(shot, flight_.stage, make.bodies, sight_);
        const std::vector<TimeRange> exposures = {kExposure};
        const TimeRange when = sight_.motions.front().piece_at(kExposure.centre_s()).when;
        const PreparedSight prepared = tracers.pair().continuous->prepare(when, kSize.film_bounds());
        TraceCounters counters;
        return static_cast<std::size_t>(std::ranges::count_if(tiles_of(kSize), [&](const PixelTile& tile) {
            const TileSamples lines = samples_of(tile, kSize, kLines);
            return lines_are_cheaper(tracers.pair(), prepared, lines.samples, exposures, counters);
        }));
    }

    static constexpr PictureSize kSize = {160, 90};
    static constexpr TimeRange kExposure = half_a_frame(0.5);
    static constexpr int kLines = 4, kSamples = 64;

    SampleFlight flight_{panning_flight()};
    Sight sight_ = flight_.sight(kSize, 1.0 / 3.0);
    FrameMaker plain_{flight_.stage, sight_, kSize, kExposure};  // the ground is lit once
};

// No further from the truth than the worse of the two that it is put together from.
TEST_F(HybridFrames, TheErrorIsThatOfLinesOrSamples) {
    const std::size_t followed = tiles_by_lines();
    EXPECT_GT(followed, tiles_of(kSize).size() / 10);
    EXPECT_LT(followed, tiles_of(kSize).size() * 9 / 10);
    const FrameMaker make = maker();
    const Frame reference = make.by_samples(1024);
    const double lines = root_mean_square(make.by_lines(kLines), reference);
    const double samples = root_mean_square(make.by_samples(kSamples), reference);
    const double both = root_mean_square(by_both(), reference);
    std::cout << "RMSE against 1,024 samples: " << kLines << " lines " << lines << ", " << kSamples << " samples "
              << samples << ", hybrid " << both << ", by lines in " << followed << " tiles of "
              << tiles_of(kSize).size() << "\n";
    EXPECT_LT(both, 1.02 * std::max(lines, samples));
}

TEST_F(HybridFrames, ThePixelsAreTheSameForAnyNumberOfThreads) {
    expect_the_same_for_any_number_of_threads([&] { return by_both(); });
}

TEST_F(HybridFrames, AFrameIsTheSameWhicheverOthersAreAskedFor) {
    expect_the_same_whichever_frames_are_asked_for(
        0.5, [&](const std::vector<TimeRange>& asked, const std::vector<TimeRange>& all) {
            return maker().expose_some(TracerKind::Hybrid, kLines, kSamples, asked, all);
        });
}

}  // namespace
}  // namespace overfly
