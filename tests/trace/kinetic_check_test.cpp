#include "trace/kinetic_check.h"

#include <gtest/gtest.h>

#include <random>

#include "support/kinetic_scenes.h"
#include "trace/kinetic.h"

namespace overfly {
namespace {

using namespace testing;

constexpr unsigned kSeed = 5;
constexpr std::size_t kSamples = 2000;
constexpr std::size_t kTile = 100;
constexpr int kWidth_px = 960;

class Check : public ::testing::Test {
  protected:
    Check() {
        std::mt19937 generator(kSeed);
        std::uniform_real_distribution<double> film(-1.0, 1.0);
        for (ImageSample& s : samples_) s = {film(generator), 0.56 * film(generator), 0.0};
    }
    // What a render counts, tile by tile.
    [[nodiscard]] TraceCounters counted(std::uint64_t every, std::size_t tile) const {
        const KineticTracer tracer(scene_, TraceCheck(scene_, every, kWidth_px));
        TraceCounters counters;
        SegmentLists lists;
        for (std::size_t first = 0; first < kSamples; first += tile) {
            tracer.trace(motion_, std::span(samples_).subspan(first, tile), std::vector<TimeRange>{motion_.when}, lists,
                         counters);
        }
        return counters;
    }

    TriangleMesh mesh_ = heightfield(60, 60, 100.0, rough_ground);
    RayScene scene_{mesh_, {0, 0, 500}};
    MotionPiece motion_ = HandMotion{{0, -2000, 900}, {20, 400, -30}, 0.1, -0.35, 0.05}.piece();
    std::vector<ImageSample> samples_{kSamples};
};

TEST_F(Check, ChecksOneInSoMany) {
    EXPECT_EQ(counted(0, kTile).checked, 0U);
    EXPECT_EQ(counted(1, kTile).checked, kSamples);
    EXPECT_NEAR(static_cast<double>(counted(10, kTile).checked), kSamples / 10.0, 60.0) << "seed " << kSeed;
}

TEST_F(Check, ChecksTheSameInAnyTiles) {
    const TraceCounters some = counted(7, kTile);
    const TraceCounters all = counted(7, kSamples);
    EXPECT_EQ(some.checked, all.checked);
    EXPECT_EQ(some.differed, all.differed);
}

TEST_F(Check, ATracerThatIsRightPasses) {
    const TraceCounters counters = counted(1, kTile);
    EXPECT_LE(counters.differed, 1U) << "seed " << kSeed;
    EXPECT_EQ(counters.differed_by_edge, counters.differed) << "seed " << kSeed;
}

TEST_F(Check, WrongAnswersAreCounted) {
    SegmentLists lists;
    TraceCounters counters;
    KineticTracer(scene_).trace(motion_, samples_, std::vector<TimeRange>{motion_.when}, lists, counters);
    const auto triangles = static_cast<TriangleId>(mesh_.triangles.size());
    for (VisibleSegment& s : lists.segments) s.triangle = (s.triangle + triangles / 2) % triangles;
    const TraceCheck check(scene_, 1, kWidth_px);
    check.run(motion_, samples_, motion_.when, lists, counters);
    EXPECT_GT(counters.differed, kSamples / 2);
    EXPECT_LT(counters.differed_by_edge, kSamples / 100);
}

}  // namespace
}  // namespace overfly
