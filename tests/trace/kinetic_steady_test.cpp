#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/parallel.h"
#include "support/kinetic_scenes.h"
#include "trace/kinetic.h"

namespace overfly {
namespace {

using namespace testing;

constexpr unsigned kSeed = 23;
constexpr FilmBounds kPicture = {-1.0, 1.0, -0.57, 0.57};

std::vector<ImageSample> random_samples(std::size_t count) {
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    std::vector<ImageSample> samples(count);
    for (ImageSample& s : samples) s = {film(generator), 0.56 * film(generator), 0.0};
    return samples;
}

SegmentLists trace(const KineticTracer& tracer, const KineticPiece& piece, std::span<const ImageSample> samples) {
    SegmentLists lists;
    TraceCounters counters;
    tracer.trace(piece, samples, std::vector<TimeRange>{piece.motion().when}, lists, counters);
    return lists;
}

class KineticSteady : public ::testing::Test {
  protected:
    TriangleMesh mesh_ = with_holes(heightfield(60, 60, 100.0, rough_ground), 5);
    RayScene scene_{mesh_, {0, 0, 500}};
    KineticTracer tracer_{scene_};
};

// What a sample sees is the same to the bit alone, and among any others, in any order.
TEST_F(KineticSteady, SamplesDoNotInfluenceEachOther) {
    const std::vector<ImageSample> samples = random_samples(400);
    std::vector<std::size_t> order(samples.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(kSeed));
    std::vector<ImageSample> shuffled;
    for (const std::size_t i : order) shuffled.push_back(samples[i]);
    for (const NamedMotion& m : all_sorts_of_motions()) {
        const KineticPiece piece = tracer_.prepare(m.piece, kPicture);
        const SegmentLists together = trace(tracer_, piece, samples);
        const SegmentLists otherwise = trace(tracer_, piece, shuffled);
        int different = 0;
        for (std::size_t k = 0; k < order.size(); ++k) {
            const std::size_t i = order[k];
            const SegmentLists alone = trace(tracer_, piece, std::span(&samples[i], 1));
            different += std::ranges::equal(together.of(i), alone.of(0)) ? 0 : 1;
            different += std::ranges::equal(together.of(i), otherwise.of(k)) ? 0 : 1;
        }
        EXPECT_EQ(different, 0) << m.name << ", seed " << kSeed;
    }
}

// What is told of an exposure is the same to the bit whichever others are asked for after the first.
TEST_F(KineticSteady, LaterExposuresDoNotInfluenceEarlierOnes) {
    const std::vector<ImageSample> samples = random_samples(2000);
    const TimeRange first = {0.0, 0.01};
    const TimeRange one = {0.4, 0.5};
    const auto within = [&](const SegmentLists& lists, std::size_t i) {
        std::vector<VisibleSegment> inside;
        for (const VisibleSegment& s : lists.of(i)) {
            const TimeRange open = intersection(s.when, one);
            if (open.duration_s() > 0.0) inside.push_back({s.triangle, open});
        }
        return inside;
    };
    for (const NamedMotion& m : all_sorts_of_motions()) {
        const KineticPiece piece = tracer_.prepare(m.piece, kPicture);
        const SegmentLists whole = trace(tracer_, piece, samples);
        for (const std::vector<TimeRange>& exposures :
             {std::vector{first, one}, std::vector{first, TimeRange{0.1, 0.2}, one},
              std::vector{first, one, TimeRange{0.61, 0.75}}, std::vector{TimeRange{0.0, 0.7}}}) {
            SegmentLists lists;
            TraceCounters counters;
            tracer_.trace(piece, samples, exposures, lists, counters);
            int different = 0;
            for (std::size_t i = 0; i < samples.size(); ++i) different += within(whole, i) == within(lists, i) ? 0 : 1;
            EXPECT_EQ(different, 0) << m.name << ", seed " << kSeed;
        }
    }
}

// And whichever thread traces them, beside whichever others.
TEST_F(KineticSteady, ThreadsAgree) {
    const std::vector<ImageSample> samples = random_samples(4096);
    constexpr std::size_t kTile = 256;
    for (const NamedMotion& m : all_sorts_of_motions()) {
        const KineticPiece piece = tracer_.prepare(m.piece, kPicture);
        const auto by_threads = [&](int threads) {
            const int before = thread_limit();
            limit_threads(threads);
            std::vector<SegmentLists> tiles(samples.size() / kTile);
            parallel_for(tiles.size(), [&](std::size_t i) {
                tiles[i] = trace(tracer_, piece, std::span(samples).subspan(i * kTile, kTile));
            });
            limit_threads(before);
            return tiles;
        };
        const std::vector<SegmentLists> alone = by_threads(1);
        const std::vector<SegmentLists> many = by_threads(4);
        for (std::size_t i = 0; i < alone.size(); ++i) {
            EXPECT_EQ(alone[i].ends, many[i].ends) << m.name;
            EXPECT_EQ(alone[i].segments, many[i].segments) << m.name;
        }
    }
}

// A sample is set down by a ray once; strides hardly ever go astray, so that it has to be again.
TEST_F(KineticSteady, StridesSeldomGoAstray) {
    const std::vector<ImageSample> samples = random_samples(4000);
    for (const NamedMotion& m : all_sorts_of_motions()) {
        SegmentLists lists;
        TraceCounters counters;
        tracer_.trace(tracer_.prepare(m.piece, kPicture), samples, std::vector<TimeRange>{m.piece.when}, lists,
                      counters);
        EXPECT_GE(counters.restarts, samples.size()) << m.name << ", seed " << kSeed;
        EXPECT_LT(counters.restarts, samples.size() + samples.size() / 50) << m.name << ", seed " << kSeed;
    }
}

// Every vector unit that this processor has gives the same answer to the bit.
TEST_F(KineticSteady, VectorUnitsAgree) {
    const std::vector<ImageSample> samples = random_samples(2000);
    for (const NamedMotion& m : all_sorts_of_motions()) {
        const SegmentLists best = trace(tracer_, tracer_.prepare(m.piece, kPicture), samples);
        for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
            const std::int64_t target = rest & -rest;
            hwy::SetSupportedTargetsForTest(target);
            hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            const SegmentLists other = trace(tracer_, tracer_.prepare(m.piece, kPicture), samples);
            EXPECT_EQ(best.ends, other.ends) << m.name << ", " << hwy::TargetName(target);
            EXPECT_EQ(best.segments, other.segments) << m.name << ", " << hwy::TargetName(target);
        }
        hwy::SetSupportedTargetsForTest(0);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    }
}

}  // namespace
}  // namespace overfly
