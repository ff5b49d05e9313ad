// Scenes that nobody means to make, and that have to come out right all the same.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/moving_scene.h"

namespace overfly {
namespace {

using testing::MovingScene;
using testing::Thing;

// Looks along y and flies along it.
RayFrame forward(double start_m, double speed_m_per_s, double t) {
    return {{0.0, start_m + speed_m_per_s * t, 0.0}, {0.5, 0, 0}, {0, 0, -0.5}, {0, 1, 0}};
}

// A square of 200 m that stands upright across the y axis.
TriangleMesh upright_square() {
    TriangleMesh mesh = testing::square(100.0);
    for (Point<Scene>& p : mesh.positions) p = {p.x, 0.0, p.y};
    return mesh;
}

SurfaceSegmentLists seen(const MovingScene& scene, const std::function<RayFrame(double)>& rays_at,
                         std::span<const ImageSample> samples) {
    const Sight sight = scene.sight(rays_at, {0.0, 1.0}, 0);
    const std::vector<TimeRange> exposures = {{0.0, 1.0}};
    SurfaceSegmentLists lists;
    TraceCounters counters;
    const SightTracer tracer(scene.surfaces(), sight);
    tracer.trace(tracer.prepare({0.0, 1.0}, testing::kPicture), samples, exposures, lists, counters);
    return lists;
}

std::vector<ImageSample> grid() {
    std::vector<ImageSample> samples;
    for (int row = -4; row <= 4; ++row) {
        for (int column = -4; column <= 4; ++column) samples.push_back({0.2 * column, 0.2 * row, 0.0});
    }
    return samples;
}

double duration_s(std::span<const SurfaceSegment> segments) {
    double sum = 0.0;
    for (const SurfaceSegment& s : segments) {
        EXPECT_TRUE(std::isfinite(s.when.begin_s) && std::isfinite(s.when.end_s));
        sum += s.when.duration_s();
    }
    return sum;
}

TEST(OddScenes, ABodyThatFillsTheViewIsAllThereIs) {
    const MovingScene scene(
        {{testing::heightfield(9, 9, 100.0, [](double, double) { return -50.0; })}, {testing::box(30, 200, 20)}});
    const auto samples = grid();
    const auto lists = seen(
        scene, [](double t) { return forward(-50, 100, t); }, samples);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_NEAR(duration_s(lists.of(i)), 1.0, 1e-12);
        for (const SurfaceSegment& s : lists.of(i)) EXPECT_EQ(s.surface, 1U);
    }
}

TEST(OddScenes, ACameraThatPassesThroughAPolygonSeesItUntilThen) {
    const MovingScene scene({{upright_square()}});
    const auto samples = grid();
    const auto lists = seen(
        scene, [](double t) { return forward(-60, 100, t); }, samples);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_FALSE(lists.of(i).empty());
        EXPECT_NEAR(lists.of(i).back().when.end_s, 0.6, 1e-9);
        EXPECT_NEAR(duration_s(lists.of(i)), 0.6, 1e-9);
    }
}

TEST(OddScenes, APolygonSeenEdgeOnAtAllTimesIsNotSeen) {
    // The camera flies in the very plane of the square, and looks along it.
    const MovingScene scene({{testing::square(100.0)}});
    const std::vector<ImageSample> samples = {{0.0, 0.0, 0.0}, {0.3, 0.0, 0.0}, {0.0, 0.2, 0.0}, {0.1, -0.2, 0.0}};
    const auto lists = seen(
        scene, [](double t) { return forward(-300, 100, t); }, samples);
    EXPECT_EQ(duration_s(lists.of(2)), 0.0);
    EXPECT_EQ(duration_s(lists.of(3)), 0.0);
    // Rays within the plane may say either; but nothing that isn't a number.
    EXPECT_LE(duration_s(lists.of(0)), 1.0);
    EXPECT_LE(duration_s(lists.of(1)), 1.0);
}

TEST(OddScenes, ATriangleWithoutAreaIsNotSeen) {
    TriangleMesh mesh = upright_square();
    mesh.positions.push_back({0, -20, 0});
    mesh.positions.push_back({10, -20, 10});
    mesh.positions.push_back({20, -20, 20});
    mesh.triangles.push_back({4, 5, 6});
    mesh.twins.push_back({kNone, kNone, kNone});
    const MovingScene scene({{mesh}});
    const auto samples = grid();
    const auto lists = seen(
        scene, [](double t) { return forward(-200, 50, t); }, samples);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (const SurfaceSegment& s : lists.of(i)) EXPECT_NE(s.triangle, 2U);
    }
}

TEST(OddScenes, WithoutAnyMotionOneThingIsSeenAllTheTime) {
    const MovingScene scene({{upright_square()}});
    const auto samples = grid();
    const auto lists = seen(
        scene, [](double) { return forward(-60, 0, 0); }, samples);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_NEAR(duration_s(lists.of(i)), 1.0, 1e-12);
        EXPECT_LE(lists.of(i).size(), 2U);
    }
}

TEST(OddScenes, AMotionThatIsNoNumberShowsNothing) {
    const TriangleMesh mesh = upright_square();
    MotionPiece piece{{0.0, 1.0}, {0, -60, 0}, {}, {{0.5, 0, 0}, {}, {}}, {{0, 0, -0.5}, {}, {}}, {{0, 1, 0}, {}, {}}};
    piece.view.c1.x = std::numeric_limits<double>::quiet_NaN();
    const std::vector<TimeRange> exposures = {{0.0, 1.0}};
    const auto samples = grid();
    SegmentLists lists;
    TraceCounters counters;
    IntervalTracer(mesh).trace(piece, samples, exposures, lists, counters);
    ASSERT_EQ(lists.ends.size(), samples.size());
    for (const VisibleSegment& s : lists.segments) EXPECT_TRUE(std::isfinite(s.when.duration_s()));
}

}  // namespace
}  // namespace overfly
