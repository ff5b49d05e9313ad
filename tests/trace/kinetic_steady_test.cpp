#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <numeric>
#include <random>

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

// Every vector unit that this processor has gives the same answer to the bit.
TEST_F(KineticSteady, VectorUnitsAgree) {
    const std::vector<ImageSample> samples = random_samples(2000);
    for (const NamedMotion& m : all_sorts_of_motions()) {
        const SegmentLists best = trace(tracer_, tracer_.prepare(m.piece, kPicture), samples);
        for (const std::int64_t target : {HWY_AVX3, HWY_AVX2, HWY_SSE4, HWY_SSSE3, HWY_SCALAR}) {
            hwy::SetSupportedTargetsForTest(0);
            if ((hwy::SupportedTargets() & target) == 0) continue;
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
