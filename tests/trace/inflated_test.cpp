#include "trace/inflated.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "support/motions.h"
#include "support/terrains.h"
#include "trace/film_box.h"
#include "trace/interval.h"
#include "trace/sample_line.h"

namespace overfly {
namespace {

using testing::HandMotion;

constexpr unsigned kSeed = 5;
constexpr FilmReach kPicture = {1.0, 0.56};

std::vector<MotionPiece> motions() {
    return {
        HandMotion{{0, -2000, 900}, {20, 400, -30}, 0.1, -0.35, 0.05}.piece(),    // forward and down
        HandMotion{{-500, 0, 1500}, {10, 20, 0}, 1.0, -0.6, 1.2}.piece(),         // a fast pan
        HandMotion{{0, 0, 1200}, {0, 0, 0}, 2.0, -0.4, 0.0}.piece(),              // hardly moving
        HandMotion{{300, -3500, 700}, {-300, 700, 0}, -0.2, 0.02, -0.2}.piece(),  // in from outside
        HandMotion{{0, -900, -300}, {0, 1500, 0}, 0.0, 0.0, 0.1}.piece(),         // under ground and out of it
    };
}

std::vector<ImageSample> some_samples() {
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    std::vector<ImageSample> samples(400);
    for (ImageSample& s : samples) s = {film(generator), kPicture.y * film(generator), 0.0};
    return samples;
}

class Volumes : public ::testing::TestWithParam<std::size_t> {
  protected:
    const TerrainMesh mesh = testing::heightfield(50, 50, 100.0, testing::rough_ground);
    const MotionPiece piece = motions()[GetParam()];
    const std::vector<ImageSample> samples = some_samples();
};

TEST_P(Volumes, BothKindsGiveTheSameSegments) {
    SegmentLists of_inflated;
    SegmentLists of_swept;
    TraceCounters inflated;
    TraceCounters swept;
    InflatedTracer(mesh, piece, kPicture).trace(samples, of_inflated, inflated);
    const std::vector<TimeRange> always = {piece.when};
    IntervalTracer(mesh).trace(piece, samples, always, of_swept, swept);
    EXPECT_EQ(of_inflated.ends, of_swept.ends) << "seed " << kSeed;
    EXPECT_EQ(of_inflated.segments, of_swept.segments) << "seed " << kSeed;
    EXPECT_GT(of_swept.segments.size(), samples.size() / 4);
    EXPECT_EQ(inflated.rays, samples.size());
    EXPECT_EQ(inflated.segments, of_inflated.segments.size());
    EXPECT_GE(inflated.box_tests, inflated.box_hits);
    EXPECT_GE(inflated.triangle_tests, inflated.triangle_hits);
    EXPECT_GE(inflated.triangle_hits * 2, inflated.segments);
}

TEST_P(Volumes, InflatedBoxesHoldWhatTheSweptRayFinds) {
    SegmentLists lists;
    TraceCounters counters;
    const std::vector<TimeRange> always = {piece.when};
    IntervalTracer(mesh).trace(piece, samples, always, lists, counters);
    const FilmBoxes boxes(mesh, piece, kPicture);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (const VisibleSegment& s : lists.of(i)) {
            const auto box = boxes.of(s.triangle);
            ASSERT_TRUE(box) << "sample " << i << ", seed " << kSeed;
            EXPECT_TRUE(box->low[0] <= samples[i].x && samples[i].x <= box->high[0]) << "sample " << i;
            EXPECT_TRUE(box->low[1] <= samples[i].y && samples[i].y <= box->high[1]) << "sample " << i;
        }
    }
}

// Every triangle asked, without any volume: neither kind leaves anything out.
TEST_P(Volumes, LeaveNothingOut) {
    SegmentLists lists;
    TraceCounters counters;
    InflatedTracer(mesh, piece, kPicture).trace(samples, lists, counters);
    for (std::size_t i = 0; i < samples.size(); i += 10) {
        const SampleLine line(mesh, piece, samples[i], piece.when);
        std::vector<CellRecord> records;
        for (TriangleId t = 0; t < mesh.triangles.size(); ++t) line.add_records(t, records);
        std::vector<VisibleSegment> seen;
        line.append_segments(line.nearest(records), seen);
        EXPECT_TRUE(std::ranges::equal(seen, lists.of(i))) << "sample " << i << ", seed " << kSeed;
    }
}

INSTANTIATE_TEST_SUITE_P(Motions, Volumes, ::testing::Range<std::size_t>(0, 5));

TEST(InflatedTracer, OfNothingSeesNothing) {
    const TriangleMesh nothing;
    const MotionPiece piece = HandMotion{{0, 0, 0}, {0, 10, 0}, 0.0, 0.0, 0.0}.piece();
    SegmentLists lists;
    TraceCounters counters;
    InflatedTracer(nothing, piece, kPicture).trace(some_samples(), lists, counters);
    EXPECT_EQ(lists.ends.size(), some_samples().size());
    EXPECT_TRUE(lists.segments.empty());
}

}  // namespace
}  // namespace overfly
