#include "trace/ray_start.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/motions.h"
#include "support/terrains.h"
#include "trace/cell_starts.h"
#include "trace/interval.h"
#include "trace/line.h"

namespace overfly {
namespace {

using testing::HandMotion;

const FixedPlane kLake = {{0, 0, 20}, {0, 0, 1}};

Vector<Scene> reflected(Vector<Scene> v, const FixedPlane& plane) {
    return v - 2.0 * dot(plane.normal, v) * plane.normal;
}

QuadraticVector reflected(const QuadraticVector& q, const FixedPlane& plane) {
    return {reflected(q.c0, plane), reflected(q.c1, plane), reflected(q.c2, plane)};
}

// The rays as the plane sends them on, unfolded.
MotionPiece reflected(const MotionPiece& piece, const FixedPlane& plane) {
    MotionPiece mirrored = piece;
    mirrored.reference = plane.on + reflected(piece.reference - plane.on, plane);
    mirrored.origin = reflected(piece.origin, plane);
    mirrored.right = reflected(piece.right, plane);
    mirrored.down = reflected(piece.down, plane);
    mirrored.view = reflected(piece.view, plane);
    return mirrored;
}

// The obvious answer: every triangle, in double.
TriangleId brute_force(const TriangleMesh& mesh, const MotionPiece& piece, const ImageSample& sample, double time_s,
                       const RayStart& start) {
    const double least_m = start.depth_at(time_s, sample.x, sample.y);
    if (!(least_m > 0.0 && std::isfinite(least_m))) return kNone;
    const double u = piece.u_at(time_s);
    const Line line = {piece.reference, piece.origin.at(u), piece.direction_at(u, sample.x, sample.y)};
    TriangleId nearest = kNone;
    double nearest_m = std::numeric_limits<double>::infinity();
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
        if (!edge_values(mesh, t, line).inside()) continue;
        const double depth_m = depth_on(mesh, t, line);
        if (depth_m > least_m * (1.0 + kAtStart) && depth_m < nearest_m) {
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

struct Found {
    int something = 0, nothing = 0;
};

// Traces random samples over some exposures and compares at random times within them.
Found expect_brute_force(const TriangleMesh& mesh, const MotionPiece& piece, const RayStart& start,
                         std::mt19937& generator) {
    const IntervalTracer tracer(mesh);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    std::vector<ImageSample> samples(150);
    for (ImageSample& s : samples) s = {film(generator), 0.56 * film(generator), 0.0};
    const std::vector<TimeRange> exposures = {{0.0, 0.3}, {0.35, 0.7}, {0.7, 1.0}};
    SegmentLists lists;
    TraceCounters counters;
    tracer.trace(piece, samples, exposures, lists, counters, &start);
    Found found;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (const TimeRange& e : exposures) {
            const double t = std::uniform_real_distribution<double>(e.begin_s, e.end_s)(generator);
            const TriangleId truth = brute_force(mesh, piece, samples[i], t, start);
            EXPECT_EQ(at_time(lists.of(i), t), truth)
                << "sample " << samples[i].x << ", " << samples[i].y << " at " << t;
            ++(truth == kNone ? found.nothing : found.something);
        }
    }
    return found;
}

std::vector<MotionPiece> motions() {
    return {
        HandMotion{{0, -2000, 900}, {20, 400, -30}, 0.1, -0.35, 0.05}.piece(),
        HandMotion{{-500, 0, 1500}, {10, 20, 0}, 1.0, -0.6, 1.2}.piece(),
        HandMotion{{300, -3500, 500}, {-300, 700, 0}, -0.2, 0.02, -0.2}.piece(),              // the horizon
        HandMotion{{0, -1000, 300}, {2000, 1500, -600}, 0.7, -0.1, 0.4}.piece(),              // fast, and into the lake
        HandMotion{{100, 100, 2500}, {150, 0, 0}, 0.0, -0.5 * std::numbers::pi, 0.3}.piece()  // straight down
    };
}

TEST(RayStart, MirroredRaysAgreeWithBruteForce) {
    const TerrainMesh mesh = testing::heightfield(50, 50, 100.0, testing::rough_ground);
    std::mt19937 generator(31);
    int something = 0;
    int nothing = 0;
    for (const MotionPiece& camera : motions()) {
        const MotionPiece mirrored = reflected(camera, kLake);
        // The plane is met at the same depth by the rays that come and by those that go.
        for (const MotionPiece* motion : {&camera, &mirrored}) {
            const Found found = expect_brute_force(mesh, mirrored, {motion, kLake}, generator);
            something += found.something;
            nothing += found.nothing;
        }
    }
    EXPECT_GT(something, 500);
    EXPECT_GT(nothing, 500);
}

// A mirror that moves, whose motion is cut otherwise than that of what is traced: where rays start has nothing to do
// with where they go.
TEST(RayStart, MirrorsInMotionAgreeWithBruteForce) {
    const TerrainMesh mesh = testing::heightfield(50, 50, 100.0, testing::rough_ground);
    std::mt19937 generator(32);
    const FixedPlane tilted = {{100, 50, 300}, normalized(Vector<Scene>{0.3, -0.5, 0.8})};
    int something = 0;
    for (const MotionPiece& camera : motions()) {
        MotionPiece relative = HandMotion{{200, -1800, 800}, {-200, 300, 100}, 0.3, -0.5, 0.9}.piece();
        relative.when = {-0.4, 1.7};
        something += expect_brute_force(mesh, camera, {&relative, tilted}, generator).something;
    }
    EXPECT_GT(something, 200);
}

// A lake that is part of the terrain that it mirrors doesn't see itself.
TEST(RayStart, TrianglesInTheMirrorsPlaneAreNotMet) {
    const TerrainMesh mesh = testing::heightfield(
        50, 50, 100.0, [](double x, double y) { return std::max(testing::rough_ground(x, y), kLake.on.z); });
    const auto is_lake = [&](TriangleId t) {
        return std::ranges::all_of(mesh.triangles[t], [&](VertexId v) { return mesh.positions[v].z == kLake.on.z; });
    };
    const IntervalTracer tracer(mesh);
    std::mt19937 generator(33);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    for (const MotionPiece& camera : motions()) {
        const MotionPiece mirrored = reflected(camera, kLake);
        const RayStart start = {&mirrored, kLake};
        std::vector<ImageSample> samples(1000);
        for (ImageSample& s : samples) s = {film(generator), film(generator), 0.0};
        SegmentLists lists;
        TraceCounters counters;
        tracer.trace(mirrored, samples, std::vector<TimeRange>{{0.0, 1.0}}, lists, counters, &start);
        for (const VisibleSegment& s : lists.segments) EXPECT_FALSE(is_lake(s.triangle));
        expect_brute_force(mesh, mirrored, start, generator);
    }
}

TEST(RayStart, InstantsAgreeWithBruteForce) {
    const TerrainMesh mesh = testing::heightfield(50, 50, 100.0, testing::rough_ground);
    const IntervalTracer tracer(mesh);
    std::mt19937 generator(34);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    for (const MotionPiece& camera : motions()) {
        const MotionPiece mirrored = reflected(camera, kLake);
        const RayStart start = {&camera, kLake};
        std::vector<ImageSample> samples(100);
        for (ImageSample& s : samples) s = {film(generator), 0.56 * film(generator), 0.0};
        SegmentLists lists;
        TraceCounters counters;
        tracer.trace(mirrored, samples, std::vector<TimeRange>{{0.37, 0.37}}, lists, counters, &start);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            EXPECT_EQ(at_time(lists.of(i), 0.37), brute_force(mesh, mirrored, samples[i], 0.37, start));
        }
    }
}

TEST(RayStart, ExposuresDoNotInfluenceEachOther) {
    const TerrainMesh mesh = testing::heightfield(50, 50, 100.0, testing::rough_ground);
    const IntervalTracer tracer(mesh);
    const MotionPiece mirrored = reflected(motions()[3], kLake);
    const RayStart start = {&mirrored, kLake};
    std::mt19937 generator(35);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    std::vector<ImageSample> samples(200);
    for (ImageSample& s : samples) s = {film(generator), 0.56 * film(generator), 0.0};
    std::vector<TimeRange> exposures(20);
    for (std::size_t k = 0; k < 20; ++k) {
        exposures[k] = {0.05 * static_cast<double>(k), 0.05 * static_cast<double>(k + 1)};
    }
    SegmentLists together;
    TraceCounters counters;
    tracer.trace(mirrored, samples, exposures, together, counters, &start);
    std::vector<SegmentLists> alone(exposures.size());
    for (std::size_t k = 0; k < exposures.size(); ++k) {
        tracer.trace(mirrored, samples, std::span(exposures).subspan(k, 1), alone[k], counters, &start);
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::vector<VisibleSegment> joined;
        for (const SegmentLists& lists : alone) {
            joined.insert(joined.end(), lists.of(i).begin(), lists.of(i).end());
        }
        const auto all = together.of(i);
        EXPECT_EQ(std::vector<VisibleSegment>(all.begin(), all.end()), joined);
    }
}

TEST(RayStart, NothingIsSeenWhereRaysDontStart) {
    const TerrainMesh mesh = testing::heightfield(20, 20, 100.0, testing::rough_ground);
    const IntervalTracer tracer(mesh);
    const MotionPiece camera = motions()[0];
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    MotionPiece broken = camera;
    broken.view.c1.y = nan;
    MotionPiece endless = camera;
    endless.origin.c2.z = infinity;
    const std::vector<RayStart> starts = {
        {&camera, {{0, 0, 0}, {0, 0, 0}}},                                      // no plane
        {&camera, {camera.reference + Vector<Scene>{0, -5000, 0}, {0, 1, 0}}},  // a plane behind the camera
        {&camera, {{0, 0, nan}, {0, 0, 1}}},
        {&camera, {{0, 0, 0}, {0, infinity, 1}}},
        {&broken, kLake},
        {&endless, kLake},
    };
    for (const RayStart& start : starts) {
        SegmentLists lists;
        TraceCounters counters;
        const std::vector<ImageSample> samples = {{0.0, 0.1, 0.0}, {0.3, 0.2, 0.0}};
        tracer.trace(camera, samples, std::vector<TimeRange>{{0.0, 0.5}, {0.5, 1.0}}, lists, counters, &start);
        EXPECT_EQ(lists.ends.size(), 2U);
        EXPECT_TRUE(lists.segments.empty());
    }
}

}  // namespace
}  // namespace overfly
