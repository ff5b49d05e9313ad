#include "shot/timeline.h"

#include <random>

#include <gtest/gtest.h>

#include "support/motions.h"
#include "support/terrains.h"
#include "trace/interval.h"
#include "trace/line.h"

namespace overfly {
namespace {

using testing::HandMotion;

constexpr unsigned kSeed = 3;

// Two pieces, the second going on where the first ends.
Motion two_pieces() {
    const MotionPiece first = HandMotion{{0, -2600, 500}, {20, 400, -30}, 0.1, -0.12, 0.05}.piece();
    MotionPiece second = HandMotion{first.origin_at(1.0), {20, 400, -30}, 0.15, -0.12, -0.1}.piece();
    second.when = {1.0, 2.0};
    Motion motion;
    motion.pieces = {first, second};
    return motion;
}

class TimelineOfAPixel : public ::testing::Test {
  protected:
    const TerrainMesh mesh = testing::heightfield(50, 50, 100.0, testing::rough_ground);
    const Motion motion = two_pieces();
    const std::vector<TimelineSurface> surfaces = {{&mesh, &motion}};
    const TimeRange when = {0.3, 1.8};

    [[nodiscard]] std::vector<ImageSample> samples() const {
        std::mt19937 generator(kSeed);
        std::uniform_real_distribution<double> film(-1.0, 1.0);
        std::vector<ImageSample> out(30);
        for (ImageSample& s : out) s = {film(generator), 0.3 * film(generator), 0.0};
        return out;
    }
    [[nodiscard]] Line line_at(const ImageSample& sample, double time_s) const {
        const MotionPiece& piece = motion.piece_at(time_s);
        const double u = piece.u_at(time_s);
        return {piece.reference, piece.origin.at(u), piece.direction_at(u, sample.x, sample.y)};
    }
};

const SightRecord* at_time(std::span<const SightRecord> records, double time_s) {
    for (const SightRecord& r : records) {
        if (r.when.contains(time_s)) return &r;
    }
    return nullptr;
}

TEST_F(TimelineOfAPixel, NamesEveryTriangleThatTheLinePasses) {
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> time(when.begin_s, when.end_s);
    std::size_t hidden = 0;
    for (const ImageSample& sample : samples()) {
        const Timeline timeline = trace_timeline(surfaces, sample, when);
        for (int k = 0; k < 5; ++k) {
            const double time_s = time(generator);
            const Line line = line_at(sample, time_s);
            std::size_t expected = 0;
            TriangleId nearest = kNone;
            double nearest_m = std::numeric_limits<double>::infinity();
            for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
                if (!edge_values(mesh, t, line).inside()) continue;
                const double depth_m = depth_on(mesh, t, line);
                if (!(depth_m > 0.0)) continue;
                ++expected;
                const auto is_it = [&](const SightRecord& r) {
                    return r.what.triangle == t && r.when.contains(time_s);
                };
                EXPECT_EQ(std::ranges::count_if(timeline.passed, is_it), 1) << "triangle " << t << " at " << time_s;
                if (depth_m < nearest_m) {
                    nearest_m = depth_m;
                    nearest = t;
                }
            }
            const auto now = [&](const SightRecord& r) { return r.when.contains(time_s); };
            EXPECT_EQ(static_cast<std::size_t>(std::ranges::count_if(timeline.passed, now)), expected);
            const SightRecord* const seen = at_time(timeline.seen, time_s);
            EXPECT_EQ(seen != nullptr ? seen->what.triangle : kNone, nearest) << "at " << time_s << ", seed " << kSeed;
            hidden += expected > 1 ? 1 : 0;
        }
    }
    EXPECT_GT(hidden, 10U);
}

TEST_F(TimelineOfAPixel, SeesWhatTheTracerSees) {
    const IntervalTracer tracer(mesh);
    for (const ImageSample& sample : samples()) {
        const Timeline timeline = trace_timeline(surfaces, sample, when);
        std::vector<VisibleSegment> wanted;
        for (const MotionPiece& piece : motion.pieces) {
            SegmentLists lists;
            TraceCounters counters;
            tracer.trace(piece, std::span(&sample, 1), std::span(&when, 1), lists, counters);
            for (const VisibleSegment& s : lists.segments) {
                const bool goes_on = !wanted.empty() && wanted.back().triangle == s.triangle &&
                                     wanted.back().when.end_s == s.when.begin_s;
                if (goes_on) {
                    wanted.back().when.end_s = s.when.end_s;
                } else {
                    wanted.push_back(s);
                }
            }
        }
        ASSERT_EQ(timeline.seen.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            EXPECT_EQ(timeline.seen[i].what.triangle, wanted[i].triangle);
            EXPECT_EQ(timeline.seen[i].when, wanted[i].when);
        }
    }
}

TEST_F(TimelineOfAPixel, RecordsAreInOrderWithDepthsFromBeginToEnd) {
    for (const ImageSample& sample : samples()) {
        const Timeline timeline = trace_timeline(surfaces, sample, when);
        EXPECT_TRUE(std::ranges::is_sorted(timeline.passed, {}, [](const SightRecord& r) { return r.when.begin_s; }));
        for (const SightRecord& r : timeline.passed) {
            ASSERT_GE(r.depth.size(), 2U);
            EXPECT_DOUBLE_EQ(r.depth.front().time_s, r.when.begin_s);
            EXPECT_DOUBLE_EQ(r.depth.back().time_s, r.when.end_s);
            for (const DepthAt& d : r.depth) {
                const double exact_m = depth_on(mesh, r.what.triangle, line_at(sample, d.time_s));
                EXPECT_NEAR(d.depth_m, exact_m, 1e-6 * exact_m);
            }
        }
    }
}

// Twice the signed area: of one sign for all three sides where the point lies in the triangle.
double side(PlanePoint a, PlanePoint b, PlanePoint p) {
    return (b.x_m - a.x_m) * (p.y_m - a.y_m) - (b.y_m - a.y_m) * (p.x_m - a.x_m);
}

TEST_F(TimelineOfAPixel, CurveLiesInTheTriangleWhileTheLinePassesIt) {
    std::size_t inside = 0;
    std::size_t crossings = 0;
    for (const ImageSample& sample : samples()) {
        const Timeline timeline = trace_timeline(surfaces, sample, when);
        for (const SightRecord& r : timeline.seen) {
            const PlaneCurve curve = plane_curve(surfaces, timeline, r.what);
            const auto& c = curve.corners;
            const double area = side(c[0], c[1], c[2]);
            const auto least_side = [&](PlanePoint p) {
                return std::min({side(c[0], c[1], p), side(c[1], c[2], p), side(c[2], c[0], p)}) / area;
            };
            EXPECT_GT(area, 0.0) << "seen from above, the ground's triangles run counterclockwise";
            for (const auto& stretch : curve.path) {
                for (const CurvePoint& p : stretch) {
                    const auto passes = [&](const SightRecord& other) {
                        return other.what == r.what && other.when.contains(p.time_s);
                    };
                    const bool is_inside = std::ranges::any_of(timeline.passed, passes);
                    EXPECT_GT(is_inside ? least_side(p.at) : -least_side(p.at), -1e-9);
                    inside += is_inside ? 1 : 0;
                }
            }
            for (const CurvePoint& p : curve.crossings) EXPECT_NEAR(least_side(p.at), 0.0, 1e-7);
            for (const CurvePoint& p : curve.false_crossings) EXPECT_LT(least_side(p.at), 0.0);
            crossings += curve.crossings.size();
        }
    }
    EXPECT_GT(inside, 100U);
    EXPECT_GT(crossings, 20U);
}

// A small body between the camera and the ground, crossing the view: for a while it hides what is behind it.
TEST_F(TimelineOfAPixel, ABodyHidesTheGround) {
    TriangleMesh body;
    body.positions = {{-150, 0, -150}, {150, 0, -150}, {0, 0, 150}};
    body.triangles = {{0, 1, 2}};
    Motion past_body;
    past_body.pieces = {HandMotion{{-400, -900, 60}, {400, 0, 0}, 0.0, -0.05, 0.0}.piece()};
    past_body.pieces.front().when = {0.0, 2.0};
    const std::vector<TimelineSurface> both = {{&mesh, &motion}, {&body, &past_body}};
    const ImageSample centre = {0.0, 0.02, 0.0};
    const Timeline alone = trace_timeline(surfaces, centre, when);
    const Timeline timeline = trace_timeline(both, centre, when);
    EXPECT_EQ(timeline.passed.size(), alone.passed.size() + 1);
    const auto of_body = [](const SightRecord& r) { return r.what.surface == 1; };
    const auto in_front = std::ranges::find_if(timeline.seen, of_body);
    ASSERT_NE(in_front, timeline.seen.end());
    EXPECT_EQ(std::ranges::count_if(timeline.seen, of_body), 1);
    for (const SightRecord& r : timeline.seen) {
        EXPECT_GT(r.when.duration_s(), 0.0);
        EXPECT_TRUE(of_body(r) || intersection(r.when, in_front->when).duration_s() <= 0.0);
    }
    for (const SightRecord& r : alone.seen) {
        if (in_front->when.contains(r.when.begin_s) && in_front->when.contains(r.when.end_s)) continue;
        const auto goes_on = [&](const SightRecord& other) { return other.what == r.what; };
        EXPECT_TRUE(std::ranges::any_of(timeline.seen, goes_on));
    }
}

TEST(Timeline, OfTheSkyIsEmpty) {
    const TerrainMesh mesh = testing::heightfield(10, 10, 100.0, testing::rough_ground);
    Motion motion;
    motion.pieces = {HandMotion{{0, 0, 5000}, {0, 10, 0}, 0.0, 1.2, 0.0}.piece()};
    const Timeline timeline =
        trace_timeline(std::vector<TimelineSurface>{{&mesh, &motion}}, {0.0, 0.0, 0.0}, {0.0, 1.0});
    EXPECT_TRUE(timeline.passed.empty());
    EXPECT_TRUE(timeline.seen.empty());
    EXPECT_EQ(timeline.pieces.size(), 1U);
}

}  // namespace
}  // namespace overfly
