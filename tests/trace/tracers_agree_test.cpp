#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/motions.h"
#include "support/terrains.h"
#include "trace/line.h"
#include "trace/tracer.h"

namespace overfly {
namespace {

using testing::HandMotion;

// The obvious answer: every triangle, in double.
TriangleId brute_force(const TerrainMesh& mesh, const MotionPiece& piece, const ImageSample& sample, double time_s) {
    const double u = piece.u_at(time_s);
    const Line line = {piece.reference, piece.origin.at(u), piece.direction_at(u, sample.x, sample.y)};
    TriangleId nearest = kNone;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
        if (!edge_values(mesh, t, line).inside()) continue;
        const double depth_m = depth_on(mesh, t, line);
        if (depth_m > 0.0 && depth_m < nearest_m) {
            nearest = t;
            nearest_m = depth_m;
        }
    }
    return nearest;
}

TriangleId at_time(std::span<const VisibleSegment> segments, double time_s) {
    for (const VisibleSegment& s : segments) {
        if (s.when.contains(time_s)) return s.triangle;
    }
    return kNone;
}

std::vector<MotionPiece> motions() {
    const double pi = std::numbers::pi;
    return {
        HandMotion{{0, -2000, 900}, {20, 400, -30}, 0.1, -0.35, 0.05}.piece(),   // forward and down
        HandMotion{{-500, 0, 1500}, {10, 20, 0}, 1.0, -0.6, 1.2}.piece(),        // a fast pan
        HandMotion{{100, 100, 2500}, {150, 0, 0}, 0.0, -0.5 * pi, 0.3}.piece(),  // straight down
        HandMotion{{0, 0, 1200}, {0, 0, 0}, 2.0, -0.1, 0.0}.piece(),             // hardly moving, over the horizon
        HandMotion{{300, -3500, 700}, {-300, 700, 0}, -0.2, 0.02, -0.2}.piece()  // in from outside
    };
}

TEST(Tracers, AgreeWithBruteForce) {
    const TerrainMesh mesh = testing::heightfield(50, 50, 100.0, testing::rough_ground);
    const RayScene scene(mesh, {0, 0, 500});
    const DiscreteTracer discrete(scene);
    const IntervalTracer interval(mesh);
    constexpr unsigned kSeed = 4;
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    std::uniform_real_distribution<double> time(0.0, 1.0);
    const std::vector<TimeRange> always = {{0.0, 1.0}};
    int pairs = 0;
    for (const MotionPiece& piece : motions()) {
        for (int i = 0; i < 300; ++i) {
            const std::vector<ImageSample> sample = {{film(generator), 0.56 * film(generator), 0.0}};
            SegmentLists lists;
            TraceCounters counters;
            interval.trace(piece, sample, always, lists, counters);
            for (int k = 0; k < 4; ++k) {
                const double t = time(generator);
                const TriangleId truth = brute_force(mesh, piece, sample[0], t);
                EXPECT_EQ(at_time(lists.of(0), t), truth) << "interval, seed " << kSeed << " pair " << pairs;
                EXPECT_EQ(discrete.visible_at(piece, sample[0].x, sample[0].y, t), truth)
                    << "discrete, seed " << kSeed << " pair " << pairs;
                ++pairs;
            }
        }
    }
}

TEST(Tracers, SegmentsAreInOrderAndApart) {
    const TerrainMesh mesh = testing::heightfield(80, 80, 60.0, testing::rough_ground);
    const IntervalTracer interval(mesh);
    const std::vector<TimeRange> always = {{0.0, 1.0}};
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    for (const MotionPiece& piece : motions()) {
        std::vector<ImageSample> samples(200);
        for (ImageSample& s : samples) s = {film(generator), film(generator), 0.0};
        SegmentLists lists;
        TraceCounters counters;
        interval.trace(piece, samples, always, lists, counters);
        ASSERT_EQ(lists.ends.size(), samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) {
            double last = 0.0;
            for (const VisibleSegment& s : lists.of(i)) {
                EXPECT_GE(s.when.begin_s, last);
                EXPECT_GT(s.when.duration_s(), 0.0);
                last = s.when.end_s;
            }
            EXPECT_LE(last, 1.0);
        }
    }
}

// Straight down onto a closed sheet that fills the view: no time without a triangle.
TEST(Tracers, NoBackgroundThroughAClosedMesh) {
    const TerrainMesh mesh = testing::heightfield(200, 200, 50.0, testing::rough_ground);
    const IntervalTracer interval(mesh);
    const MotionPiece piece = HandMotion{{0, 0, 2500}, {400, 300, 0}, 0.3, -0.5 * std::numbers::pi, 0.4}.piece();
    const std::vector<TimeRange> always = {{0.0, 1.0}};
    std::mt19937 generator(9);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    std::vector<ImageSample> samples(5000);
    for (ImageSample& s : samples) s = {film(generator), 0.56 * film(generator), 0.0};
    SegmentLists lists;
    TraceCounters counters;
    interval.trace(piece, samples, always, lists, counters);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        double last = 0.0;
        for (const VisibleSegment& s : lists.of(i)) {
            EXPECT_EQ(s.when.begin_s, last);
            last = s.when.end_s;
        }
        EXPECT_EQ(last, 1.0);
    }
}

// What is found during an exposure does not depend on what other exposures were asked for.
TEST(Tracers, ExposuresDoNotInfluenceEachOther) {
    const TerrainMesh mesh = testing::heightfield(80, 80, 60.0, testing::rough_ground);
    const IntervalTracer interval(mesh);
    const TimeRange exposure = {0.30, 0.42};
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    for (const MotionPiece& piece : motions()) {
        std::vector<ImageSample> samples(300);
        for (ImageSample& s : samples) s = {film(generator), 0.56 * film(generator), 0.0};
        SegmentLists alone;
        SegmentLists among;
        TraceCounters counters;
        interval.trace(piece, samples, std::vector<TimeRange>{exposure}, alone, counters);
        interval.trace(piece, samples, std::vector<TimeRange>{{0.0, 0.1}, exposure, {0.6, 1.0}}, among, counters);
        const auto within = [&](std::span<const VisibleSegment> segments) {
            std::vector<VisibleSegment> clipped;
            for (const VisibleSegment& s : segments) {
                const TimeRange when = intersection(s.when, exposure);
                if (when.duration_s() > 0.0) clipped.push_back({s.triangle, when});
            }
            return clipped;
        };
        for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(within(alone.of(i)), within(among.of(i)));
    }
}

}  // namespace
}  // namespace overfly
