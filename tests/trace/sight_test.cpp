#include "trace/sight.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "support/moving_scene.h"

namespace overfly {
namespace {

using testing::MovingScene;
using testing::Seen;
using testing::SeenAt;
using testing::Thing;

constexpr unsigned kSeed = 11;

// A camera that flies forward and turns.
RayFrame camera_at(double time_s) {
    const double heading = 0.3 + 0.4 * time_s;
    const double pitch = -0.35 + 0.1 * std::sin(2.0 * time_s);
    const Vector<Scene> view = {std::sin(heading) * std::cos(pitch), std::cos(heading) * std::cos(pitch),
                                std::sin(pitch)};
    const Vector<Scene> right = normalized(cross(view, Vector<Scene>{0, 0, 1}));
    return {{-300.0 + 150.0 * time_s, -1500.0 + 400.0 * time_s, 900.0 - 60.0 * time_s * time_s},
            0.6 * right,
            0.6 * cross(view, right),
            view};
}

Transform<Scene, Body> spinning(double t) {
    return {testing::turned({0.3, 0.2, 1.0}, 3.0 * t), {-150.0 + 220.0 * t, -450.0 - 100.0 * t, 560.0}};
}
Transform<Scene, Body> crossing(double t) {
    return {testing::turned({1.0, 0.1, 0.0}, 0.4 + 0.2 * t), {100.0 - 150.0 * t, -520.0, 540.0 + 30.0 * t}};
}
Transform<Scene, Body> lake(double) { return {testing::turned({0, 0, 1}, 0.2), {-100.0, -600.0, 420.0}}; }

std::vector<Thing> things() {
    const FixedPlane level = {{0, 0, 0}, {0, 0, 1}};
    return {{testing::heightfield(40, 40, 100.0, testing::rough_ground), {}},
            {testing::box(160, 60, 90), spinning},
            {testing::box(120, 120, 20), crossing},
            {testing::square(450), lake, true, level},
            {testing::square(150), [](double t) { return crossing(t + 0.7); }, true, level}};
}

const Seen* seen_at(std::span<const SurfaceSegment> segments, double time_s, Seen& seen, const SurfaceSegment** found) {
    for (const SurfaceSegment& s : segments) {
        if (!s.when.contains(time_s)) continue;
        seen = {s.surface, s.triangle};
        *found = &s;
        return &seen;
    }
    return nullptr;
}

// What a sample sees at a time, mirror after mirror.
std::vector<Seen> chain_at(const SurfaceSegmentLists& lists, std::size_t sample, double time_s) {
    std::vector<Seen> chain;
    const SurfaceSegment* found = nullptr;
    Seen seen;
    if (seen_at(lists.of(sample), time_s, seen, &found) == nullptr) return {Seen{}};
    chain.push_back(seen);
    while (found->reflected != kNone) {
        found = &lists.reflected[found->reflected];
        chain.push_back({found->triangle == kNone ? 0 : found->surface, found->triangle});
    }
    return chain;
}

struct Comparison {
    int pairs = 0, different = 0, bodies = 0, in_mirrors = 0;
    int outside = 0;  // segments that reach beyond what was asked for
};

Comparison compare_with_brute_force(int mirrors) {
    const MovingScene scene(things());
    const Sight sight = scene.sight(camera_at, {0.0, 0.5, 1.0}, mirrors);
    const SightTracer tracer(scene.surfaces(), sight);
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> film(-1.0, 1.0), time(0.0, 0.5);
    Comparison result;
    for (const TimeRange when : {TimeRange{0.0, 0.5}, TimeRange{0.5, 1.0}}) {
        std::vector<ImageSample> samples(400);
        for (ImageSample& s : samples) s = {film(generator), 0.7 * film(generator), 0.0};
        // One that goes on beyond what is traced.
        const std::vector<TimeRange> exposures = {{-0.1, 1.1}};
        SurfaceSegmentLists lists;
        TraceCounters counters;
        tracer.trace(tracer.prepare(when, testing::kPicture), samples, exposures, lists, counters);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            for (int k = 0; k < 5; ++k) {
                const double t = when.begin_s + time(generator);
                const std::vector<Seen> truth = brute_force_chain(scene, sight, samples[i], t);
                for (const SurfaceSegment& s : lists.of(i)) result.outside += intersection(s.when, when) != s.when;
                ++result.pairs;
                result.bodies += truth[0].surface > 0 ? 1 : 0;
                result.in_mirrors += truth.size() > 1 ? 1 : 0;
                result.different += chain_at(lists, i, t) != truth ? 1 : 0;
            }
        }
    }
    return result;
}

TEST(SightTracer, AgreesWithBruteForceOnBodiesThatPassThroughEachOther) {
    const Comparison c = compare_with_brute_force(0);
    EXPECT_GT(c.bodies, c.pairs / 5);
    EXPECT_EQ(c.different, 0) << "of " << c.pairs << ", seed " << kSeed;
    EXPECT_EQ(c.outside, 0);
}

TEST(SightTracer, AgreesWithBruteForceInMirrors) {
    const Comparison c = compare_with_brute_force(1);
    EXPECT_GT(c.in_mirrors, c.pairs / 20);
    EXPECT_EQ(c.different, 0) << "of " << c.pairs << ", seed " << kSeed;
}

TEST(SightTracer, AgreesWithBruteForceInMirrorsOfMirrors) {
    const Comparison c = compare_with_brute_force(2);
    EXPECT_EQ(c.different, 0) << "of " << c.pairs << ", seed " << kSeed;
}

// The discrete tracer: instants, in float.
TEST(SightTracer, SeesTheSameByInstants) {
    const MovingScene scene(things(), true, normalized(Vector<Scene>{0.7, 0.3, 0.25}));
    const Sight sight = scene.sight(camera_at, {0.0, 0.5, 1.0}, 2);
    const SightTracer tracer(scene.surfaces(), sight);
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> film(-1.0, 1.0), time(0.0, 0.5);
    int pairs = 0, different = 0;
    for (int instant = 0; instant < 10; ++instant) {
        std::vector<ImageSample> samples(400);
        for (ImageSample& s : samples) s = {film(generator), 0.7 * film(generator), 0.0};
        const double t = time(generator);
        const std::vector<TimeRange> exposures = {{t, t}};
        SurfaceSegmentLists lists;
        TraceCounters counters;
        tracer.trace(tracer.prepare({0.0, 0.5}, testing::kPicture), samples, exposures, lists, counters);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            ++pairs;
            different += chain_at(lists, i, t) != brute_force_chain(scene, sight, samples[i], t) ? 1 : 0;
        }
    }
    // Where a body ends before the sky, and where two surfaces pass through each other, float decides.
    EXPECT_LE(different, pairs / 1000) << "of " << pairs << ", seed " << kSeed;
}

// The sun is behind what is seen.
bool faces_away(const MovingScene& scene, const Sight& sight, const ImageSample& sample, const SeenAt& seen, double t) {
    const TriangleMesh& mesh = scene.things()[seen.what.surface].mesh;
    const auto& corner = mesh.triangles[seen.what.triangle];
    const Point<Scene> p0 = mesh.positions[corner[0]];
    const Vector<Scene> normal = cross(mesh.positions[corner[1]] - p0, mesh.positions[corner[2]] - p0);
    const MotionPiece& piece = sight.motions[seen.what.surface].piece_at(t);
    const double u = piece.u_at(t);
    return dot(normal, piece.to_sun.at(u)) * dot(normal, piece.direction_at(u, sample.x, sample.y)) >= 0.0;
}

TEST(SightTracer, AgreesWithBruteForceOnShadows) {
    for (const Vector<Scene> to_sun :
         {normalized(Vector<Scene>{0.7, 0.3, 0.25}), normalized(Vector<Scene>{-0.4, 0.2, 0.8})}) {
        const MovingScene scene(things(), false, to_sun);
        const Sight sight = scene.sight(camera_at, {0.0, 0.5, 1.0}, 0);
        const SightTracer tracer(scene.surfaces(), sight);
        std::mt19937 generator(kSeed);
        std::uniform_real_distribution<double> film(-1.0, 1.0), time(0.0, 1.0);
        std::vector<ImageSample> samples(400);
        for (ImageSample& s : samples) s = {film(generator), 0.7 * film(generator), 0.0};
        const std::vector<TimeRange> exposures = {{0.0, 0.5}};
        SurfaceSegmentLists lists;
        TraceCounters counters;
        tracer.trace(tracer.prepare({0.0, 0.5}, testing::kPicture), samples, exposures, lists, counters);
        int pairs = 0, dark = 0, different = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            for (int k = 0; k < 5; ++k) {
                const double t = 0.5 * time(generator);
                const SeenAt truth = brute_force(scene, sight, samples[i], t);
                if (truth.what.triangle == kNone || faces_away(scene, sight, samples[i], truth, t)) continue;
                const bool in_shadow = brute_force_shadow(scene, sight, samples[i], truth, t);
                Seen seen;
                const SurfaceSegment* found = nullptr;
                ASSERT_NE(seen_at(lists.of(i), t, seen, &found), nullptr);
                ++pairs;
                dark += in_shadow ? 1 : 0;
                different += found->in_shadow != in_shadow ? 1 : 0;
            }
        }
        EXPECT_GT(pairs, 500);
        EXPECT_GT(dark, pairs / 20);
        EXPECT_EQ(different, 0) << "of " << pairs << ", seed " << kSeed;
    }
}

}  // namespace
}  // namespace overfly
