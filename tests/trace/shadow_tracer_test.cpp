#include "trace/shadow_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/motions.h"
#include "support/terrains.h"
#include "trace/interval.h"
#include "trace/line.h"
#include "trace/plane_depth.h"

namespace overfly {
namespace {

using testing::HandMotion;

constexpr double kPi = std::numbers::pi;

// A sample may see a triangle's corner for a rounding or two. Whether that is in the shadow of the next triangle, which
// is as far away as the point is from the edge, is a matter of rounding, too.
constexpr double kBlink_s = 1e-12;

// The obvious answer: the point in double, and every triangle between it and the sun.
bool is_dark(const TriangleMesh& blocker, const MotionPiece& motion, const ShadowQuery& query, double time_s) {
    const auto [x, y, phase] = query.sample;
    const PlaneDepth depth(*query.mesh, query.triangle, *query.motion, x, y);
    const double s = depth.at(query.motion->u_at(time_s));
    const double u = motion.u_at(time_s);
    const Line line = {motion.reference, motion.origin.at(u) + s * motion.direction_at(u, x, y), motion.to_sun.at(u)};
    for (TriangleId t = 0; t < blocker.triangles.size(); ++t) {
        if (&blocker == query.mesh && t == query.triangle) continue;
        if (edge_values(blocker, t, line).inside() && depth_on(blocker, t, line) > 0.0) return true;
    }
    return false;
}

bool contains(std::span<const TimeRange> dark, double time_s) {
    return std::ranges::any_of(dark, [&](const TimeRange& d) { return d.contains(time_s); });
}

QuadraticVector constant(Vector<Scene> v) { return {v, {}, {}}; }

// A sun that turns about the vertical with the time.
QuadraticVector turning(double heading_rad, double elevation_rad, double turn_rad) {
    const auto at = [&](double u) {
        const double h = heading_rad + turn_rad * u;
        return Vector<Scene>{std::cos(elevation_rad) * std::sin(h), std::cos(elevation_rad) * std::cos(h),
                             std::sin(elevation_rad)};
    };
    const Vector<Scene> a = at(0.0);
    const Vector<Scene> b = at(0.5);
    const Vector<Scene> c = at(1.0);
    return {a, 4.0 * b - 3.0 * a - c, 2.0 * a + 2.0 * c - 4.0 * b};
}

MotionPiece with_sun(MotionPiece piece, const QuadraticVector& to_sun) {
    piece.to_sun = to_sun;
    return piece;
}

MotionPiece hover() {
    MotionPiece piece = HandMotion{{-300, -1500, 1300}, {}, 0.2, -0.6, 0.0}.piece();
    piece.origin = piece.right = piece.down = piece.view = {};
    const MotionPiece still = HandMotion{{-300, -1500, 1300}, {}, 0.2, -0.6, 0.0}.piece();
    piece.right.c0 = still.right.c0;
    piece.down.c0 = still.down.c0;
    piece.view.c0 = still.view.c0;
    return piece;
}

// The camera over the ground.
std::vector<MotionPiece> motions() {
    return {HandMotion{{0, -2000, 900}, {20, 400, -30}, 0.1, -0.35, 0.05}.piece(),
            HandMotion{{100, 100, 2500}, {150, 0, 0}, 0.0, -0.5 * kPi, 0.3}.piece(),
            HandMotion{{-500, -500, 1500}, {2500, 1800, 0}, 1.0, -0.8, 0.7}.piece(),  // very fast
            hover()};
}

const std::vector<Vector<Scene>>& suns() {
    static const std::vector<Vector<Scene>> all = {normalized(Vector<Scene>{0.5, 0.3, 0.7}),
                                                   normalized(Vector<Scene>{0.9, 0.3, 0.12}),
                                                   normalized(Vector<Scene>{-0.2, 0.9, 0.05})};
    return all;
}

struct Ground {
    TerrainMesh mesh = testing::heightfield(50, 50, 100.0, testing::rough_ground);
    IntervalTracer tracer{mesh};

    // What random samples see, as questions.
    [[nodiscard]] std::vector<ShadowQuery> queries(const MotionPiece& piece, std::mt19937& generator) const {
        std::uniform_real_distribution<double> film(-1.0, 1.0);
        std::vector<ImageSample> samples(60);
        for (ImageSample& s : samples) s = {film(generator), 0.56 * film(generator), 0.0};
        const std::vector<TimeRange> exposures = {{0.0, 0.2}, {0.25, 0.6}, {0.6, 0.61}, {0.7, 1.0}};
        SegmentLists lists;
        TraceCounters counters;
        tracer.trace(piece, samples, exposures, lists, counters);
        std::vector<ShadowQuery> all;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            for (const VisibleSegment& s : lists.of(i)) {
                if (s.when.duration_s() > kBlink_s) all.push_back({samples[i], &mesh, s.triangle, &piece, s.when});
            }
        }
        return all;
    }
};

// A rough sheet in the air, by its own frame.
TerrainMesh sheet() {
    TerrainMesh mesh = testing::heightfield(14, 14, 70.0, testing::rough_ground);
    for (Point<Scene>& p : mesh.positions) p.z = 0.3 * p.z + 900.0;
    return mesh;
}

// The same rays relative to a body that turns about the vertical by `turn_rad` and rises while a camera looks on: any
// quadratics will do, as the point that is seen is defined through them.
MotionPiece in_turning_frame(const MotionPiece& piece, Vector<Scene> to_sun, double turn_rad) {
    const auto turned = [&](Vector<Scene> v, double u) {
        const double c = std::cos(turn_rad * u);
        const double s = std::sin(turn_rad * u);
        return Vector<Scene>{c * v.x + s * v.y, c * v.y - s * v.x, v.z};
    };
    const auto through = [&](const QuadraticVector& q, Vector<Scene> shift) {
        const Vector<Scene> a = turned(q.at(0.0) + shift, 0.0);
        const Vector<Scene> b = turned(q.at(0.5) + shift, 0.5);
        const Vector<Scene> c = turned(q.at(1.0) + shift, 1.0);
        return QuadraticVector{a, 4.0 * b - 3.0 * a - c, 2.0 * a + 2.0 * c - 4.0 * b};
    };
    MotionPiece relative = piece;
    relative.origin = through(piece.origin, piece.reference - Point<Scene>{});
    relative.reference = {};
    relative.right = through(piece.right, {});
    relative.down = through(piece.down, {});
    relative.view = through(piece.view, {});
    relative.to_sun = through(constant(to_sun), {});
    return relative;
}

// Asks all, and compares at random times. Returns how often it was dark, of how many.
std::pair<int, int> expect_brute_force(const TriangleMesh& blocker, const StaticBvh& bvh, const MotionPiece& motion,
                                       std::span<const ShadowQuery> queries, std::mt19937& generator) {
    ShadowLists lists;
    TraceCounters counters;
    ShadowTracer(blocker, bvh).trace(motion, queries, lists, counters);
    EXPECT_EQ(lists.ends.size(), queries.size());
    int dark = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        const TimeRange when = queries[i].when;
        std::uniform_real_distribution<double> time(when.begin_s, when.end_s);
        const double t = time(generator);
        const bool truth = is_dark(blocker, motion, queries[i], t);
        EXPECT_EQ(contains(lists.of(i), t), truth) << "query " << i << " at " << t;
        dark += truth ? 1 : 0;
    }
    return {dark, static_cast<int>(queries.size())};
}

TEST(ShadowTracer, GroundOnItselfAgreesWithBruteForce) {
    const Ground ground;
    std::mt19937 generator(21);
    int dark = 0;
    int all = 0;
    for (const MotionPiece& camera : motions()) {
        for (const Vector<Scene>& sun : suns()) {
            const MotionPiece piece = with_sun(camera, constant(sun));
            const auto queries = ground.queries(piece, generator);
            const auto [of_these, count] =
                expect_brute_force(ground.mesh, ground.tracer.hierarchy(), piece, queries, generator);
            dark += of_these;
            all += count;
        }
    }
    EXPECT_GT(all, 4000);
    EXPECT_GT(dark, all / 10);
    EXPECT_LT(dark, 9 * all / 10);
}

TEST(ShadowTracer, BodiesAgreeWithBruteForce) {
    const Ground ground;
    const TerrainMesh body = sheet();
    const StaticBvh bvh = build_static_bvh(body);
    std::mt19937 generator(22);
    int dark = 0;
    int all = 0;
    for (const MotionPiece& camera : motions()) {
        for (const double turn_rad : {0.0, 0.4, -1.5}) {
            const auto queries = ground.queries(camera, generator);
            const MotionPiece relative = in_turning_frame(camera, suns()[0], turn_rad);
            const auto [of_these, count] = expect_brute_force(body, bvh, relative, queries, generator);
            dark += of_these;
            all += count;
        }
    }
    EXPECT_GT(dark, all / 100);
    EXPECT_LT(dark, all / 2);
}

// A body whose motion is cut at other times than the ground's.
TEST(ShadowTracer, PiecesMayBeCutOtherwise) {
    const Ground ground;
    const TerrainMesh body = sheet();
    const StaticBvh bvh = build_static_bvh(body);
    std::mt19937 generator(23);
    const MotionPiece camera = motions()[0];
    MotionPiece relative = in_turning_frame(camera, suns()[0], 0.3);
    relative.when = {-0.7, 1.9};
    expect_brute_force(body, bvh, relative, ground.queries(camera, generator), generator);
}

TEST(ShadowTracer, InstantsAgreeWithBruteForce) {
    const Ground ground;
    std::mt19937 generator(24);
    for (const MotionPiece& camera : motions()) {
        for (const bool turns : {false, true}) {
            const MotionPiece piece = with_sun(camera, turns ? turning(1.0, 0.15, 0.8) : constant(suns()[1]));
            std::vector<ShadowQuery> queries = ground.queries(piece, generator);
            for (ShadowQuery& q : queries) q.when.begin_s = q.when.end_s = q.when.centre_s();
            const auto [dark, all] =
                expect_brute_force(ground.mesh, ground.tracer.hierarchy(), piece, queries, generator);
            EXPECT_GT(dark, all / 20);
        }
    }
}

// Which other questions are asked along with one doesn't change its answer.
TEST(ShadowTracer, QueriesDoNotInfluenceEachOther) {
    const Ground ground;
    std::mt19937 generator(25);
    for (const bool turns : {false, true}) {
        const MotionPiece piece = with_sun(motions()[2], turns ? turning(1.0, 0.15, 0.8) : constant(suns()[1]));
        const auto queries = ground.queries(piece, generator);
        const ShadowTracer tracer(ground.mesh, ground.tracer.hierarchy());
        TraceCounters counters;
        ShadowLists together;
        tracer.trace(piece, queries, together, counters);
        for (const std::size_t at_once : {1U, 3U, 7U}) {
            ShadowLists lists;
            for (std::size_t first = 0; first < queries.size(); first += at_once) {
                const std::size_t count = std::min<std::size_t>(at_once, queries.size() - first);
                tracer.trace(piece, std::span(queries).subspan(first, count), lists, counters);
            }
            EXPECT_EQ(lists.dark, together.dark);
            EXPECT_EQ(lists.ends, together.ends);
        }
    }
}

// The polynomials of higher degree say the same: a direction that only grows longer doesn't turn.
TEST(ShadowTracer, BothDegreesAgree) {
    const Ground ground;
    std::mt19937 generator(26);
    const MotionPiece still = with_sun(motions()[0], constant(suns()[1]));
    const MotionPiece growing = with_sun(still, {suns()[1], 0.7 * suns()[1], 0.2 * suns()[1]});
    const auto queries = ground.queries(still, generator);
    const ShadowTracer tracer(ground.mesh, ground.tracer.hierarchy());
    TraceCounters counters;
    ShadowLists a;
    ShadowLists b;
    tracer.trace(still, queries, a, counters);
    tracer.trace(growing, queries, b, counters);
    ASSERT_EQ(a.ends, b.ends);
    for (std::size_t i = 0; i < a.dark.size(); ++i) {
        EXPECT_NEAR(a.dark[i].begin_s, b.dark[i].begin_s, 1e-9);
        EXPECT_NEAR(a.dark[i].end_s, b.dark[i].end_s, 1e-9);
    }
}

TEST(ShadowTracer, ListsAreInOrderApartAndWithin) {
    const Ground ground;
    std::mt19937 generator(27);
    for (const MotionPiece& camera : motions()) {
        const MotionPiece piece = with_sun(camera, turning(2.0, 0.2, 1.0));
        const auto queries = ground.queries(piece, generator);
        ShadowLists lists;
        TraceCounters counters;
        ShadowTracer(ground.mesh, ground.tracer.hierarchy()).trace(piece, queries, lists, counters);
        for (std::size_t i = 0; i < queries.size(); ++i) {
            double last = queries[i].when.begin_s;
            for (const TimeRange& d : lists.of(i)) {
                EXPECT_TRUE(d.begin_s > last || (d.begin_s == last && last == queries[i].when.begin_s));
                EXPECT_GT(d.duration_s(), 0.0);
                last = d.end_s;
            }
            EXPECT_LE(last, queries[i].when.end_s);
        }
    }
}

// A line of sight that swings through the plane of the triangle: the point goes through infinity and comes back from
// the other side. Nobody sees that, but the answer holds for the point nevertheless.
TEST(ShadowTracer, PointThroughInfinity) {
    const Ground ground;
    const TerrainMesh body = sheet();
    const StaticBvh bvh = build_static_bvh(body);
    std::mt19937 generator(28);
    std::uniform_real_distribution<double> film(-1.0, 1.0);
    std::uniform_real_distribution<double> time(0.0, 1.0);
    const MotionPiece camera = HandMotion{{0, -900, 700}, {100, 300, 0}, 0.1, -0.1, 1.0}.piece();
    const MotionPiece relative = in_turning_frame(camera, suns()[0], 0.4);
    std::vector<ShadowQuery> queries(200);
    int turned = 0;
    for (ShadowQuery& q : queries) {
        const auto triangle = static_cast<TriangleId>(generator() % ground.mesh.triangles.size());
        q = {{film(generator), film(generator), 0.0}, &ground.mesh, triangle, &camera, {0.0, 1.0}};
        const PlaneDepth depth(ground.mesh, triangle, camera, q.sample.x, q.sample.y);
        turned += sign_changes<2>(depth.denominator_over(0.0, 1.0)) > 0 ? 1 : 0;
    }
    EXPECT_GT(turned, 10);
    for (int i = 0; i < 10; ++i) expect_brute_force(body, bvh, relative, queries, generator);
}

}  // namespace
}  // namespace overfly
