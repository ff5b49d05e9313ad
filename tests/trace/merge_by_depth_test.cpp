#include "trace/merge_by_depth.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "mesh/connect_triangles.h"

namespace overfly {
namespace {

constexpr unsigned kSeed = 5;
constexpr ImageSample kStraightAhead = {0.0, 0.0, 0.0};

// Two triangles in one upright plane through the origin, looked at along the y axis.
TriangleMesh wall() {
    TriangleMesh mesh;
    mesh.positions = {{-9, 0, -9}, {9, 0, -9}, {9, 0, 9}, {-9, 0, 9}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    connect_triangles(mesh);
    return mesh;
}

// In the frame of a wall that is at depth c0 + c1 u + c2 u^2.
MotionPiece at_depth(double c0, double c1 = 0.0, double c2 = 0.0) {
    MotionPiece piece;
    piece.when = {0.0, 1.0};
    piece.origin = {{0, -c0, 0}, {0, -c1, 0}, {0, -c2, 0}};
    piece.right = {{1, 0, 0}, {}, {}};
    piece.down = {{0, 0, -1}, {}, {}};
    piece.view = {{0, 1, 0}, {}, {}};
    return piece;
}

using Segments = std::vector<SurfaceSegment>;

class MergeByDepth : public ::testing::Test {
  protected:
    [[nodiscard]] Segments merge(const Segments& a, const Segments& b) const {
        Segments out;
        merge_by_depth(a, b, meshes_, kStraightAhead, out);
        return out;
    }
    // Which of the two is told first doesn't matter.
    void expect_merged(const Segments& a, const Segments& b, const Segments& expected) const {
        EXPECT_EQ(merge(a, b), expected);
        EXPECT_EQ(merge(b, a), expected);
    }

    const TriangleMesh mesh_ = wall();
    const std::vector<const TriangleMesh*> meshes_ = {&mesh_, &mesh_, &mesh_};
    const MotionPiece near_ = at_depth(10.0), far_ = at_depth(20.0);
};

SurfaceSegment segment(std::uint32_t surface, TimeRange when, const MotionPiece& motion, TriangleId triangle = 0) {
    return {surface, triangle, when, &motion};
}

TEST_F(MergeByDepth, TheNearerHidesTheFurther) {
    expect_merged({segment(0, {0.0, 1.0}, far_)}, {segment(1, {0.25, 0.5}, near_)},
                  {segment(0, {0.0, 0.25}, far_), segment(1, {0.25, 0.5}, near_), segment(0, {0.5, 1.0}, far_)});
    expect_merged({segment(0, {0.0, 1.0}, near_)}, {segment(1, {0.25, 0.5}, far_)}, {segment(0, {0.0, 1.0}, near_)});
}

TEST_F(MergeByDepth, OneListAloneStaysAsItIs) {
    const Segments alone = {segment(1, {0.0, 0.25}, near_), segment(1, {0.5, 0.5}, near_),
                            segment(1, {0.75, 1.0}, far_, 1)};
    expect_merged(alone, {}, alone);
    expect_merged({}, {}, {});
}

TEST_F(MergeByDepth, AppendsToWhatIsThere) {
    Segments out = {segment(2, {0.0, 0.5}, near_)};
    merge_by_depth(Segments{segment(2, {0.5, 1.0}, near_)}, Segments{}, meshes_, kStraightAhead, out);
    EXPECT_EQ(out, (Segments{segment(2, {0.0, 0.5}, near_), segment(2, {0.5, 1.0}, near_)}));
}

TEST_F(MergeByDepth, SplitsWhereDepthsCross) {
    // 12 - 4 u is 10 at one half; 12 - 12 u + 12 u^2 there and back again at (3 -+ sqrt(3)) / 6.
    const MotionPiece once = at_depth(12.0, -4.0), twice = at_depth(12.0, -12.0, 12.0);
    expect_merged({segment(0, {0.0, 1.0}, near_)}, {segment(1, {0.0, 1.0}, once)},
                  {segment(0, {0.0, 0.5}, near_), segment(1, {0.5, 1.0}, once)});
    const Segments out = merge({segment(0, {0.0, 1.0}, near_)}, {segment(1, {0.0, 1.0}, twice)});
    ASSERT_EQ(out.size(), 3U);
    EXPECT_EQ((std::array{out[0].surface, out[1].surface, out[2].surface}), (std::array{0U, 1U, 0U}));
    EXPECT_NEAR(out[1].when.begin_s, (3.0 - std::sqrt(3.0)) / 6.0, 1e-14);
    EXPECT_NEAR(out[1].when.end_s, (3.0 + std::sqrt(3.0)) / 6.0, 1e-14);
}

// The pieces of two surfaces' motions begin and end where they like.
TEST_F(MergeByDepth, SplitsWhereDepthsCrossInPiecesOfTheirOwn) {
    // 13 - 8 (t + 0.5) / 2 is 10 at one quarter.
    MotionPiece late = at_depth(13.0, -8.0);
    late.when = {-0.5, 1.5};
    expect_merged({segment(0, {0.0, 1.0}, near_)}, {segment(1, {0.0, 1.0}, late)},
                  {segment(0, {0.0, 0.25}, near_), segment(1, {0.25, 1.0}, late)});
}

TEST_F(MergeByDepth, OfTwoEquallyNearTheHigherSurface) {
    expect_merged({segment(1, {0.0, 1.0}, near_)}, {segment(2, {0.0, 1.0}, near_, 1)},
                  {segment(2, {0.0, 1.0}, near_, 1)});
    expect_merged({segment(1, {0.5, 0.5}, near_)}, {segment(0, {0.5, 0.5}, near_)}, {segment(1, {0.5, 0.5}, near_)});
}

// Nobody sees a single instant of a stretch, wherever it is.
TEST_F(MergeByDepth, TouchingIsNotCrossing) {
    for (const double touch_u : {0.25, 0.5, 0.625}) {
        const MotionPiece touching = at_depth(10.0 + 8.0 * touch_u * touch_u, -16.0 * touch_u, 8.0);
        expect_merged({segment(0, {0.0, 1.0}, near_)}, {segment(1, {0.0, 1.0}, touching)},
                      {segment(0, {0.0, 1.0}, near_)});
    }
}

TEST_F(MergeByDepth, InstantsAreComparedWithThoseOfTheSameInstant) {
    expect_merged({segment(0, {0.125, 0.125}, near_), segment(0, {0.5, 0.5}, near_)},
                  {segment(1, {0.125, 0.125}, far_), segment(1, {0.25, 0.25}, far_)},
                  {segment(0, {0.125, 0.125}, near_), segment(1, {0.25, 0.25}, far_), segment(0, {0.5, 0.5}, near_)});
}

TEST_F(MergeByDepth, TheSkyIsBehindEverything) {
    expect_merged(
        {segment(0, {0.0, 1.0}, near_, kNone)}, {segment(1, {0.25, 0.5}, far_)},
        {segment(0, {0.0, 0.25}, near_, kNone), segment(1, {0.25, 0.5}, far_), segment(0, {0.5, 1.0}, near_, kNone)});
    expect_merged({segment(0, {0.5, 0.5}, near_, kNone)}, {segment(1, {0.5, 0.5}, far_)},
                  {segment(1, {0.5, 0.5}, far_)});
}

TEST_F(MergeByDepth, JoinsWhatGoesOnBehindAJoint) {
    const Segments joint = {segment(1, {0.0, 0.5}, far_), segment(1, {0.5, 1.0}, far_, 1)};
    expect_merged({segment(0, {0.0, 1.0}, near_)}, joint, {segment(0, {0.0, 1.0}, near_)});
    // Another triangle, or the same in the shadow, is something else.
    const MotionPiece further = at_depth(30.0);
    expect_merged({segment(0, {0.0, 1.0}, further)}, joint, joint);
    Segments dark = {segment(1, {0.0, 0.5}, far_), segment(1, {0.5, 1.0}, far_)};
    dark[1].in_shadow = true;
    expect_merged({segment(0, {0.0, 1.0}, further)}, dark, dark);
}

// Some stretches between gaps, one after another.
Segments random_list(std::mt19937& generator, std::uint32_t surface, std::span<const MotionPiece> motions) {
    std::uniform_int_distribution<int> coin(0, 2);
    Segments list;
    for (int k = 0; k < 16; ++k) {
        if (coin(generator) == 0) continue;
        const MotionPiece& motion = motions[static_cast<std::size_t>(coin(generator))];
        list.push_back(segment(surface, {k / 16.0, (k + 1) / 16.0}, motion, coin(generator) == 0 ? 1 : 0));
    }
    return list;
}

const SurfaceSegment* at_time(const Segments& list, double time_s) {
    const auto found = std::ranges::find_if(list, [&](const SurfaceSegment& s) { return s.when.contains(time_s); });
    return found == list.end() ? nullptr : &*found;
}

double depth_m(const SurfaceSegment& s, double time_s) { return -s.motion->origin.at(s.motion->u_at(time_s)).y; }

// At a time inside the stretches: who has to be seen.
const SurfaceSegment* expected_at(const Segments& a, const Segments& b, double time_s) {
    const SurfaceSegment* of_a = at_time(a, time_s);
    const SurfaceSegment* of_b = at_time(b, time_s);
    if (of_a == nullptr || of_b == nullptr) return of_a == nullptr ? of_b : of_a;
    return depth_m(*of_a, time_s) < depth_m(*of_b, time_s) ? of_a : of_b;
}

TEST_F(MergeByDepth, CoversTheUnionInOrderWithoutOverlap) {
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> number(-20.0, 20.0), time(0.0, 1.0);
    for (int round = 0; round < 500; ++round) {
        std::vector<MotionPiece> motions;
        for (int k = 0; k < 6; ++k)
            motions.push_back(at_depth(60.0 + number(generator), number(generator), number(generator)));
        const Segments a = random_list(generator, 0, std::span(motions).first(3));
        const Segments b = random_list(generator, 1, std::span(motions).last(3));
        const Segments out = merge(a, b);
        double reached_s = 0.0;
        for (const SurfaceSegment& s : out) {
            EXPECT_GT(s.when.duration_s(), 0.0);
            EXPECT_GE(s.when.begin_s, reached_s);
            reached_s = s.when.end_s;
        }
        for (int k = 0; k < 50; ++k) {
            const double t = time(generator);
            const SurfaceSegment* seen = at_time(out, t);
            const SurfaceSegment* expected = expected_at(a, b, t);
            const std::string where =
                "seed " + std::to_string(kSeed) + ", round " + std::to_string(round) + ", at " + std::to_string(t);
            ASSERT_EQ(seen == nullptr, expected == nullptr) << where;
            if (seen == nullptr) continue;
            EXPECT_EQ(std::pair(seen->surface, seen->motion), std::pair(expected->surface, expected->motion)) << where;
        }
    }
}

}  // namespace
}  // namespace overfly
