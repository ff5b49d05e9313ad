#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "trace/paper_agreement.h"
#include "trace/paper_continuous.h"
#include "trace/paper_discrete.h"
#include "trace/paper_embree.h"
#include "trace/paper_polygons.h"
#include "trace/paper_ray.h"
#include "trace/paper_records.h"
#include "trace/paper_stretches.h"

namespace overfly {
namespace {

constexpr double kTie_px = 1e-6;

// Looks along y; half the picture is half a length wide at a depth of one.
PaperCamera small_camera() {
    PaperCamera camera;
    camera.rows = 30;
    camera.columns = 40;
    camera.per_column = {1.0 / camera.columns, 0.0, 0.0};
    camera.per_row = {0.0, 0.0, -1.0 / camera.columns};
    camera.first = Vector<Scene>{0.0, 1.0, 0.0} - 0.5 * (camera.columns - 1) * camera.per_column -
                   0.5 * (camera.rows - 1) * camera.per_row;
    return camera;
}

// A regular polygon around `centre`, spanned by two vectors.
struct Disc {
    Point<Scene> centre;
    Vector<Scene> across, up;
    std::uint32_t corners = 4;

    void add_to(PaperScene& scene, std::uint32_t body) const {
        scene.polygons.push_back({static_cast<std::uint32_t>(scene.corners.size()), corners, body});
        for (std::uint32_t k = 0; k < corners; ++k) {
            const double turn = 2.0 * std::numbers::pi * (k + 0.5) / corners;
            scene.corners.push_back(static_cast<VertexId>(scene.positions.size()));
            scene.positions.push_back(centre + std::cos(turn) * across + std::sin(turn) * up);
        }
    }
};

// Bodies that stand still, move at constant speed and along parabolas, with polygons of three to six corners that pass
// in front of and through each other, some of them behind the camera.
PaperScene random_scene(unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&](double size) {
        return size * Vector<Scene>{unit(generator), unit(generator), unit(generator)};
    };
    PaperScene scene;
    scene.camera = small_camera();
    scene.frames = 21;
    scene.bodies = {{}, {vector(4.0), {}}, {vector(4.0), vector(4.0)}, {vector(1.0), vector(6.0)}};
    for (std::uint32_t i = 0; i < 24; ++i) {
        const Point<Scene> centre = Point<Scene>{0.0, 5.0, 0.0} + vector(6.0);
        Disc{centre, vector(2.0), vector(2.0), 3 + i % 4}.add_to(scene, i % 4);
    }
    return scene;
}

// Every polygon, in double.
PaperFrames::Pixel brute_force(const PaperScene& scene, int frame, int row, int column) {
    PaperPolygons polygons;
    polygons_at(scene, scene.u_of(frame), polygons);
    const Vector<Scene> origin = scene.camera.eye - Point<Scene>{};
    const Vector<Scene> d = scene.camera.direction(row, column);
    double nearest = std::numeric_limits<double>::infinity();
    PaperFrames::Pixel seen = PaperFrames::kNothing;
    for (std::size_t p = 0; p < polygons.polygons.size(); ++p) {
        const PaperPolygons::Polygon& polygon = polygons.polygons[p];
        const double facing = dot(polygon.normal, d);
        const double depth = (polygon.offset - dot(polygon.normal, origin)) / facing;
        bool inside = depth > 0.0 && depth < nearest;
        for (const auto& edge : polygons.edges_of(polygon)) inside &= edge.at(d, cross(origin, d)) * facing <= 0.0;
        if (!inside) continue;
        nearest = depth;
        seen = static_cast<PaperFrames::Pixel>(p);
    }
    return seen;
}

TEST(PaperTracers, AgreeOnRandomScenes) {
    std::uint64_t seen = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
        const PaperScene scene = random_scene(seed);
        const PaperHierarchy tree = build_paper_hierarchy(scene);
        PaperFrames discrete(scene);
        const PaperCounters counted = trace_paper_discrete(scene, tree, discrete);
        for (const PaperVolumes volumes : {PaperVolumes::Carried, PaperVolumes::Inflated}) {
            PaperFrames continuous(scene);
            const PaperCounters c = trace_paper_continuous(scene, tree, volumes, continuous);
            const PaperAgreement agreement = compare(scene, discrete, continuous, kTie_px);
            EXPECT_EQ(agreement.unexplained, 0U) << "seed " << seed;
            EXPECT_LE(agreement.differing, 2U) << "seed " << seed;
            EXPECT_LE(c.bv_hits, c.bv_tests);
            EXPECT_LE(c.poly_hits, c.poly_tests);
        }
        PaperFrames embree(scene);
        trace_paper_embree(scene, embree);
        EXPECT_EQ(compare(scene, discrete, embree, 0.01).unexplained, 0U) << "seed " << seed;
        seen += counted.poly_hits;
    }
    EXPECT_GT(seen, 100'000U) << "the scenes are not empty";
}

TEST(PaperTracers, AgreeWithBruteForce) {
    for (unsigned seed = 100; seed < 104; ++seed) {
        const PaperScene scene = random_scene(seed);
        const PaperHierarchy tree = build_paper_hierarchy(scene);
        PaperFrames continuous(scene);
        trace_paper_continuous(scene, tree, PaperVolumes::Carried, continuous);
        for (int frame = 0; frame < scene.frames; frame += 4) {
            for (int row = 0; row < scene.camera.rows; row += 3) {
                for (int column = 0; column < scene.camera.columns; column += 3) {
                    EXPECT_EQ(continuous.at(frame, row, column), brute_force(scene, frame, row, column))
                        << "seed " << seed << " frame " << frame << " row " << row << " column " << column;
                }
            }
        }
    }
}

// The paper's first animation in small: one test of everything, per frame or per animation.
TEST(PaperTracers, OneStaticPolygonCostsOneTestEach) {
    PaperScene scene;
    scene.camera = small_camera();
    scene.frames = 7;
    scene.bodies.emplace_back();
    Disc{{0.0, 3.0, 0.0}, {4.0, 0.0, 0.0}, {0.0, 0.0, 4.0}}.add_to(scene, 0);
    const PaperHierarchy tree = build_paper_hierarchy(scene);
    PaperFrames frames(scene);
    const std::uint64_t pixels = 30 * 40;
    const std::uint64_t rays = pixels * 7;
    EXPECT_EQ(trace_paper_discrete(scene, tree, frames), (PaperCounters{rays, rays, rays, rays}));
    EXPECT_EQ(frames.at(6, 29, 39), 0);
    for (const PaperVolumes volumes : {PaperVolumes::Carried, PaperVolumes::Inflated}) {
        EXPECT_EQ(trace_paper_continuous(scene, tree, volumes, frames),
                  (PaperCounters{pixels, pixels, pixels, pixels}));
        EXPECT_EQ(frames.at(6, 29, 39), 0);
    }
}

// A swept ray meets every box that the ray, moved by hand, meets at any time; and few others where its way is straight
// and the box ahead.
TEST(PaperTracers, SweptRayMissesNoBox) {
    constexpr unsigned kSeed = 12;
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const auto vector = [&](double size) {
        return size * Vector<Scene>{unit(generator), unit(generator), unit(generator)};
    };
    int met = 0;
    int met_straight = 0;
    int met_straight_in_vain = 0;
    for (int i = 0; i < 20'000; ++i) {
        Vector<Scene> d = vector(1.0);
        if (i % 7 == 0) d.x = 0.0;
        const PaperDirection direction(d);
        const Vector<Scene> first = vector(3.0);
        const bool is_straight = i % 3 == 0;
        const PaperMotion motion = {i % 5 == 0 ? Vector<Scene>{} : vector(3.0),
                                    is_straight ? Vector<Scene>{} : vector(2.0)};
        const PaperSweptRay swept(direction, {first, first - 0.5 * motion.velocity, first - motion.at(1.0)}, 20.0);
        const bool is_ahead = i % 2 == 0;
        const Vector<Scene> low = (is_ahead ? first + 6.0 * normalized(d) : Vector<Scene>{}) + vector(3.0);
        const Vector<Scene> high = low + Vector<Scene>{2.0 * std::abs(unit(generator)), std::abs(unit(generator)), 0.5};
        const PaperBox box = {{low.x, low.y, low.z, high.x, high.y, high.z}};
        bool truth = false;
        for (int k = 0; k <= 200; ++k) {
            const PaperStillRay still(direction, Point<Scene>{} + (first - motion.at(k / 200.0)));
            truth |= still.meets(box, std::numeric_limits<double>::infinity());
        }
        const bool is_met = swept.meets(box);
        EXPECT_TRUE(is_met || !truth) << "seed " << kSeed << " box " << i;
        met += truth ? 1 : 0;
        met_straight += truth && is_straight && is_ahead ? 1 : 0;
        met_straight_in_vain += is_met && !truth && is_straight && is_ahead ? 1 : 0;
    }
    EXPECT_GT(met, 1'000);
    EXPECT_LT(met_straight_in_vain, met_straight / 10);
}

TEST(PaperOcclusion, SplitsWhereDepthsCross) {
    PaperRecordList records;
    records.add({0.2, 0.9, {3.0, 3.0, 3.0}, 1});
    records.add({0.0, 1.0, {2.0, 3.0, 4.0}, 0});  // 2 + 2 u: crosses 3 at a half
    PaperOcclusion occlusion;
    const std::vector<PaperRecord> seen = occlusion.nearest(records);
    ASSERT_EQ(seen.size(), 3U);
    const std::vector<std::uint32_t> polygons = {0, 1, 0};
    const std::vector<double> ends = {0.5, 0.9, 1.0};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(seen[i].polygon, polygons[i]);
        EXPECT_NEAR(seen[i].end, ends[i], 1e-15);
        EXPECT_EQ(seen[i].begin, i == 0 ? 0.0 : seen[i - 1].end);
    }
}

TEST(PaperOcclusion, KeepsGapsAndDropsWhatIsHidden) {
    PaperRecordList records;
    records.add({0.1, 0.4, {1.0, 1.0, 1.0}, 0});
    records.add({0.2, 0.3, {2.0, 2.0, 2.0}, 1});
    records.add({0.6, 0.8, {2.0, 2.0, 2.0}, 2});
    PaperOcclusion occlusion;
    const std::vector<PaperRecord> seen = occlusion.nearest(records);
    const std::vector<PaperRecord> wanted = {{0.1, 0.4, {1.0, 1.0, 1.0}, 0}, {0.6, 0.8, {2.0, 2.0, 2.0}, 2}};
    EXPECT_EQ(seen, wanted);
}

TEST(PaperStretches, CutOutLeavesTheRest) {
    PaperStretches stretches;
    stretches.hold_always();
    stretches.cut_out(0.0, 0.1);
    stretches.cut_out(0.4, 0.5);
    stretches.cut_out(0.7, 0.8);
    stretches.cut_out(0.45, 0.75);
    ASSERT_EQ(stretches.get().size(), 2U);
    EXPECT_EQ(stretches.get()[0].begin, 0.1);
    EXPECT_EQ(stretches.get()[0].end, 0.4);
    EXPECT_EQ(stretches.get()[1].begin, 0.8);
    EXPECT_EQ(stretches.get()[1].end, 1.0);
    stretches.cut_out(0.0, 1.0);
    EXPECT_TRUE(stretches.get().empty());
}

}  // namespace
}  // namespace overfly
