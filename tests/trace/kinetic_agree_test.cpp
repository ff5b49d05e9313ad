#include <gtest/gtest.h>

#include <random>

#include "support/kinetic_scenes.h"
#include "trace/kinetic.h"
#include "trace/tracer.h"

namespace overfly {
namespace {

using namespace testing;

TriangleId at_time(std::span<const VisibleSegment> segments, double time_s) {
    for (const VisibleSegment& s : segments) {
        if (s.when.contains(time_s)) return s.triangle;
    }
    return kNone;
}

constexpr unsigned kSeed = 17;

struct Outcome {
    int pairs = 0, different = 0;
};

// The kinetic tracer beside the interval tracer at random times of random samples.
Outcome compare(const TriangleMesh& mesh, const MotionPiece& piece, int samples_count, TraceCounters& counters) {
    const RayScene scene(mesh, {0, 0, 500});
    const IntervalTracer interval(mesh);
    const KineticTracer kinetic(scene);
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    std::uniform_real_distribution<double> time(0.0, 1.0);
    std::vector<ImageSample> samples(static_cast<std::size_t>(samples_count));
    for (ImageSample& s : samples) s = {film(generator), 0.56 * film(generator), 0.0};
    const std::vector<TimeRange> always = {{0.0, 1.0}};
    SegmentLists truth;
    SegmentLists walked;
    TraceCounters ignored;
    interval.trace(piece, samples, always, truth, ignored);
    kinetic.trace(piece, samples, always, walked, counters);
    Outcome outcome;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (int k = 0; k < 4; ++k) {
            const double t = time(generator);
            ++outcome.pairs;
            if (at_time(truth.of(i), t) != at_time(walked.of(i), t)) ++outcome.different;
        }
    }
    return outcome;
}

void expect_agreement(const TriangleMesh& mesh, int samples) {
    for (const NamedMotion& m : all_sorts_of_motions()) {
        TraceCounters counters;
        const Outcome outcome = compare(mesh, m.piece, samples, counters);
        // One in ten thousand may be a tie that no one could decide.
        EXPECT_LE(outcome.different * 10'000, outcome.pairs)
            << m.name << ", of " << outcome.pairs << ", seed " << kSeed;
        EXPECT_LE(counters.lost, 2U) << m.name;
        EXPECT_GT(counters.segments, 0U) << m.name;
    }
}

TEST(Kinetic, AgreesWithIntervalOnRoughGround) { expect_agreement(heightfield(60, 60, 100.0, rough_ground), 2500); }

TEST(Kinetic, AgreesWithIntervalAroundHolesAndBorders) {
    expect_agreement(with_holes(heightfield(60, 60, 100.0, rough_ground), 3), 2500);
}

TEST(Kinetic, AgreesWithIntervalAtSheerSteps) { expect_agreement(heightfield(120, 120, 50.0, town), 600); }

// Only what is exposed has to be told, but all of that.
TEST(Kinetic, TellsOfExposuresWhatItTellsOfThePiece) {
    const TriangleMesh mesh = heightfield(60, 60, 100.0, rough_ground);
    const RayScene scene(mesh, {0, 0, 500});
    const KineticTracer kinetic(scene);
    const std::vector<TimeRange> exposures = {{0.2, 0.3}, {0.55, 0.55}, {0.6, 0.9}};
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    std::vector<ImageSample> samples(500);
    for (ImageSample& s : samples) s = {film(generator), 0.56 * film(generator), 0.0};
    for (const NamedMotion& m : all_sorts_of_motions()) {
        SegmentLists whole;
        SegmentLists part;
        TraceCounters counters;
        kinetic.trace(m.piece, samples, std::vector<TimeRange>{m.piece.when}, whole, counters);
        kinetic.trace(m.piece, samples, exposures, part, counters);
        int different = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            for (const double t : {0.2001, 0.25, 0.2999, 0.55, 0.6001, 0.7, 0.8999})
                different += at_time(whole.of(i), t) == at_time(part.of(i), t) ? 0 : 1;
        }
        EXPECT_EQ(different, 0) << m.name << ", seed " << kSeed;
    }
}

TEST(Kinetic, AnInstantIsASegmentWithoutDuration) {
    const TriangleMesh mesh = heightfield(20, 20, 100.0, rough_ground);
    const RayScene scene(mesh, {0, 0, 500});
    const MotionPiece piece = HandMotion{{0, 0, 2000}, {10, 0, 0}, 0.0, -0.5 * std::numbers::pi, 0.0}.piece();
    SegmentLists lists;
    TraceCounters counters;
    KineticTracer(scene).trace(piece, std::vector<ImageSample>{{0.1, 0.2, 0.0}}, std::vector<TimeRange>{{0.5, 0.5}},
                               lists, counters);
    ASSERT_EQ(lists.segments.size(), 1U);
    EXPECT_EQ(lists.segments[0].when, (TimeRange{0.5, 0.5}));
}

TEST(Kinetic, AnEmptyMeshIsAllSky) {
    const TriangleMesh mesh;
    const RayScene scene(mesh, {0, 0, 0});
    const MotionPiece piece = HandMotion{{0, 0, 2000}, {10, 0, 0}, 0.0, -0.5, 0.0}.piece();
    SegmentLists lists;
    TraceCounters counters;
    KineticTracer(scene).trace(piece, std::vector<ImageSample>{{0.1, 0.2, 0.0}}, std::vector<TimeRange>{piece.when},
                               lists, counters);
    EXPECT_EQ(lists.ends.size(), 1U);
    EXPECT_TRUE(lists.segments.empty());
}

}  // namespace
}  // namespace overfly
