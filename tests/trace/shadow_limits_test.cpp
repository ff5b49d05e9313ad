#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/terrains.h"
#include "trace/shadow_tracer.h"

namespace overfly {
namespace {

QuadraticVector constant(Vector<Scene> v) { return {v, {}, {}}; }

// A square awning over flat ground, seen straight from above while the camera goes by.
struct Awning {
    TerrainMesh ground = testing::heightfield(2, 2, 4000.0, [](double, double) { return 0.0; });
    TerrainMesh square = testing::heightfield(2, 2, 200.0, [](double, double) { return 300.0; });
    StaticBvh bvh = build_static_bvh(square);
    MotionPiece motion;

    Awning() {
        motion = {{0.0, 1.0},          {-800.0, 10.0, 1000.0}, constant({}),
                  constant({1, 0, 0}), constant({0, -1, 0}),   constant({0, 0, -1})};
        motion.origin.c1 = {1000.0, 0.0, 0.0};
        motion.to_sun = constant(normalized(Vector<Scene>{1.0, 0.0, 1.0}));
    }
    // The triangle that is north-east of the diagonal, or south-west of it: their planes are the same.
    [[nodiscard]] ShadowQuery query(TimeRange when) const { return {{}, &ground, 0, &motion, when}; }
};

TEST(ShadowTracer, TimesAreThoseOfGeometry) {
    const Awning awning;
    ShadowLists lists;
    TraceCounters counters;
    const std::vector<ShadowQuery> queries = {awning.query({0.0, 1.0}), awning.query({0.45, 0.5}),
                                              awning.query({0.7, 0.9})};
    ShadowTracer(awning.square, awning.bvh).trace(awning.motion, queries, lists, counters);
    // From x = -800 + 1000 t the line towards the sun is at x + 300 when as high as the awning, from -100 to 100.
    ASSERT_EQ(lists.of(0).size(), 1U);
    EXPECT_NEAR(lists.of(0)[0].begin_s, 0.4, 1e-12);
    EXPECT_NEAR(lists.of(0)[0].end_s, 0.6, 1e-12);
    ASSERT_EQ(lists.of(1).size(), 1U);
    EXPECT_EQ(lists.of(1)[0], (TimeRange{0.45, 0.5}));
    EXPECT_TRUE(lists.of(2).empty());
}

// A line of sight that swings up through the horizon: what it meets goes to infinity on one side and comes back from
// the other, where nobody would see it. Its control points do not bound it then.
TEST(ShadowTracer, PointThatComesBackFromInfinity) {
    Awning awning;
    awning.motion.reference = {0.0, 10.0, 100.0};
    awning.motion.origin = constant({});
    awning.motion.view = {{1.0, 0.0, -0.5}, {0.0, 0.0, 1.1}, {}};
    for (Point<Scene>& p : awning.square.positions) p.x -= 4700.0;
    const StaticBvh bvh = build_static_bvh(awning.square);
    ShadowLists lists;
    TraceCounters counters;
    const std::vector<ShadowQuery> queries = {awning.query({0.0, 1.0})};
    ShadowTracer(awning.square, bvh).trace(awning.motion, queries, lists, counters);
    // At x = 100 / (0.5 - 1.1 t), from -5100 to -4900.
    ASSERT_EQ(lists.dark.size(), 1U);
    EXPECT_NEAR(lists.dark[0].begin_s, (0.5 + 100.0 / 5100.0) / 1.1, 1e-11);
    EXPECT_NEAR(lists.dark[0].end_s, (0.5 + 100.0 / 4900.0) / 1.1, 1e-11);
}

// What is below the ground that is seen, or behind it as the sun sees it, throws no shadow on it.
TEST(ShadowTracer, OnlyWhatIsInFrontCounts) {
    Awning awning;
    for (Point<Scene>& p : awning.square.positions) p.z = -300.0;
    const StaticBvh bvh = build_static_bvh(awning.square);
    ShadowLists lists;
    TraceCounters counters;
    const std::vector<ShadowQuery> queries = {awning.query({0.0, 1.0})};
    ShadowTracer(awning.square, bvh).trace(awning.motion, queries, lists, counters);
    EXPECT_TRUE(lists.dark.empty());
}

void expect_defined(const TriangleMesh& mesh, const MotionPiece& motion, const ShadowQuery& query) {
    const StaticBvh bvh = build_static_bvh(mesh);
    ShadowLists lists;
    TraceCounters counters;
    const std::vector<ShadowQuery> queries(3, query);
    ShadowTracer(mesh, bvh).trace(motion, queries, lists, counters);
    ASSERT_EQ(lists.ends.size(), 3U);
    for (const TimeRange& d : lists.dark) {
        EXPECT_GE(d.begin_s, query.when.begin_s);
        EXPECT_LE(d.end_s, query.when.end_s);
        EXPECT_LE(d.begin_s, d.end_s);
    }
}

TEST(ShadowTracer, SunInThePlaneOfTriangles) {
    Awning awning;
    awning.motion.to_sun = constant({1, 0, 0});
    expect_defined(awning.ground, awning.motion, awning.query({0.0, 1.0}));
    expect_defined(awning.square, awning.motion, awning.query({0.0, 1.0}));
    // A sun that rises through the plane.
    awning.motion.to_sun = {{1, 0, -0.5}, {0, 0, 1}, {}};
    expect_defined(awning.ground, awning.motion, awning.query({0.0, 1.0}));
    // A wall that the sun sees edge-on throws no shadow that lasts.
    awning.motion.to_sun = constant(normalized(Vector<Scene>{1.0, 0.0, 1.0}));
    for (Point<Scene>& p : awning.square.positions) p = {p.x, 7.0, 300.0 + p.y};
    expect_defined(awning.square, awning.motion, awning.query({0.0, 1.0}));
}

TEST(ShadowTracer, CameraInThePlaneOfWhatIsSeen) {
    Awning awning;
    awning.motion.reference.z = 0.0;
    expect_defined(awning.square, awning.motion, awning.query({0.0, 1.0}));
    expect_defined(awning.ground, awning.motion, awning.query({0.0, 1.0}));
    // And looking along it.
    awning.motion.view = constant({1, 0, 0});
    expect_defined(awning.square, awning.motion, awning.query({0.0, 1.0}));
    expect_defined(awning.ground, awning.motion, awning.query({0.0, 1.0}));
}

TEST(ShadowTracer, WhatIsNotFiniteThrowsNoShadow) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, infinity, 1e200}) {
        for (const int where : {0, 1, 2}) {
            Awning awning;
            if (where == 0) awning.motion.origin.c1.x = bad;
            if (where == 1) awning.motion.view.c2.z = bad;
            if (where == 2) awning.motion.to_sun.c0.y = bad;
            expect_defined(awning.square, awning.motion, awning.query({0.0, 1.0}));
            ShadowLists lists;
            TraceCounters counters;
            const std::vector<ShadowQuery> queries = {awning.query({0.0, 1.0})};
            ShadowTracer(awning.square, awning.bvh).trace(awning.motion, queries, lists, counters);
            EXPECT_TRUE(std::isfinite(bad) || lists.dark.empty());
        }
    }
}

TEST(ShadowTracer, NothingThrowsNoShadow) {
    const Awning awning;
    const TriangleMesh nothing;
    const StaticBvh bvh = build_static_bvh(nothing);
    ShadowLists lists;
    TraceCounters counters;
    const std::vector<ShadowQuery> queries = {awning.query({0.0, 1.0})};
    ShadowTracer(nothing, bvh).trace(awning.motion, queries, lists, counters);
    EXPECT_TRUE(lists.of(0).empty());
}

}  // namespace
}  // namespace overfly
