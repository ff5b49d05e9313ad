#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "core/parallel.h"
#include "two_ways/blurred_frame.h"

namespace overfly {
namespace {

using namespace testing;

// A fast pan low over the ground: it rushes past in front, and stands nearly still far away.
ShareFlight panning_flight() {
    return {{{0.0, 0.35, 0.30, 0.01, attitude(20, -8, 0)}, {1.0, 0.36, 0.31, 0.01, attitude(110, -8, 0)}}};
}

class HybridFrames : public ::testing::Test {
  protected:
    HybridFrames() {
        PreparedTerrain blanca = prepared(OVERFLY_SOURCE_DIR "/terrain/blanca_peak_utm13n_75m.tif");
        const FlightDocument flight = flight_over(blanca.scene.report, panning_flight());
        stage_.emplace(std::move(blanca), middle_of(flight));
        sight_ = sight_of(motion_over(flight, *stage_, {0.01, kSize.width, kSize.height, 1.0 / 3.0}));
    }
    [[nodiscard]] FrameMaker maker() const { return {*stage_, sight_, kSize, kExposure}; }
    [[nodiscard]] Frame by_both() const { return maker().expose(TracerKind::Hybrid, kLines, kSamples); }

    // How many of the picture's tiles are followed.
    [[nodiscard]] std::size_t tiles_by_lines() const {
        const FrameMaker make = maker();
        ShotDocument shot;
        shot.sampling.tracer = TracerKind::Hybrid;
        shot.sampling.lines = kLines;
        shot.sampling.samples = kSamples;
        const ShotTracers tracers(shot, *stage_, make.bodies, sight_);
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
    static constexpr TimeRange kExposure = {0.5, 0.5 + 1.0 / 48.0};
    static constexpr int kLines = 4, kSamples = 64;

    std::optional<Stage> stage_;
    Sight sight_;
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
    const int before = thread_limit();
    limit_threads(1);
    const Frame one = by_both();
    limit_threads(2);
    const Frame two = by_both();
    limit_threads(before);
    EXPECT_TRUE(one == two);
}

TEST_F(HybridFrames, AFrameIsTheSameWhicheverOthersAreAskedFor) {
    std::vector<TimeRange> exposures;
    for (int k = 0; k < 5; ++k) exposures.push_back({0.5 + k / 24.0, 0.5 + k / 24.0 + 1.0 / 48.0});
    const auto frames_of = [&](const std::vector<TimeRange>& asked) {
        return maker().expose_some(TracerKind::Hybrid, kLines, kSamples, asked, exposures);
    };
    const std::vector<Frame> all = frames_of(exposures);
    EXPECT_TRUE(frames_of({exposures[0]}).front() == all[0]);
    const std::vector<Frame> some = frames_of({exposures[1], exposures[4]});
    EXPECT_TRUE(some[0] == all[1]);
    EXPECT_TRUE(some[1] == all[4]);
}

}  // namespace
}  // namespace overfly
