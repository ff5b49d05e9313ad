#include "trace/film_box.h"

#include <random>

#include <gtest/gtest.h>

#include "support/motions.h"
#include "support/terrains.h"

namespace overfly {
namespace {

using testing::HandMotion;

constexpr unsigned kSeed = 11;
constexpr FilmReach kReach = {1.5, 1.0};

// Where a point is seen: by Cramer's rule in the camera's vectors at that instant.
Vector<Scene> film_place(const MotionPiece& piece, Point<Scene> p, double u) {
    const Vector<Scene> y = p - piece.origin_at(u);
    const Vector<Scene> right = piece.right.at(u);
    const Vector<Scene> down = piece.down.at(u);
    const Vector<Scene> view = piece.view.at(u);
    const double volume = dot(right, cross(down, view));
    const double depth_m = dot(y, cross(right, down)) / volume;
    return {dot(y, cross(down, view)) / volume / depth_m, dot(y, cross(view, right)) / volume / depth_m, depth_m};
}

// Any point of a triangle that is seen at any time lies in the triangle's box.
void expect_contains(const TerrainMesh& mesh, const MotionPiece& piece) {
    const FilmBoxes boxes(mesh, piece, kReach);
    std::mt19937 generator(kSeed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    int seen = 0;
    for (int i = 0; i < 200'000; ++i) {
        const auto t = static_cast<TriangleId>(generator() % mesh.triangles.size());
        const double u = share(generator);
        const double b = share(generator);
        const double c = share(generator) * (1.0 - b);
        const auto corner = [&](std::size_t k) { return mesh.positions[mesh.triangles[t][k]]; };
        const Point<Scene> p = corner(0) + b * (corner(1) - corner(0)) + c * (corner(2) - corner(0));
        const Vector<Scene> at = film_place(piece, p, u);
        if (!(at.z > 0.0) || std::abs(at.x) > kReach.x || std::abs(at.y) > kReach.y) continue;
        ++seen;
        const auto box = boxes.of(t);
        ASSERT_TRUE(box) << "triangle " << t << " at " << u << ", seed " << kSeed;
        EXPECT_TRUE(box->low[0] <= at.x && at.x <= box->high[0]) << "triangle " << t << " at " << u;
        EXPECT_TRUE(box->low[1] <= at.y && at.y <= box->high[1]) << "triangle " << t << " at " << u;
        EXPECT_TRUE(box->low[2] <= at.z && at.z <= box->high[2]) << "triangle " << t << " at " << u;
    }
    EXPECT_GT(seen, 1000);
}

TEST(FilmBox, ContainsItsTriangleAtAllTimes) {
    const TerrainMesh mesh = testing::heightfield(40, 40, 100.0, testing::rough_ground);
    expect_contains(mesh, HandMotion{{0, -2000, 900}, {20, 400, -30}, 0.1, -0.35, 0.05}.piece());
    expect_contains(mesh, HandMotion{{-500, 0, 1500}, {10, 20, 0}, 1.0, -0.6, 1.2}.piece());
    expect_contains(mesh, HandMotion{{100, 100, 2500}, {150, 0, 0}, 0.0, -1.57, 0.3}.piece());
}

// One triangle, which the camera flies past or through: corners before it, beside it and behind it.
TEST(FilmBox, OfATriangleThatTheCameraPassesIsTheWholeFilm) {
    TriangleMesh mesh;
    mesh.positions = {{-50, 100, -10}, {50, 100, -10}, {0, 100, 40}};
    mesh.triangles = {{0, 1, 2}};
    const HandMotion through = {{0, 0, 0}, {0, 200, 0}, 0.0, 0.0, 0.0};
    const auto box = FilmBoxes(mesh, through.piece(), kReach).of(0);
    ASSERT_TRUE(box);
    EXPECT_EQ(box->low[0], -kReach.x);
    EXPECT_EQ(box->high[0], kReach.x);
    EXPECT_EQ(box->low[1], -kReach.y);
    EXPECT_EQ(box->high[1], kReach.y);
    EXPECT_EQ(box->low[2], 0.0);
    EXPECT_NEAR(box->high[2], 100.0, 3.0);
}

TEST(FilmBox, NoneForWhatIsNeverSeen) {
    TriangleMesh mesh;
    mesh.positions = {{-50, -100, -10}, {50, -100, -10}, {0, -100, 40},
                      {5000, 100, 0},   {5000, 200, 0},  {5000, 150, 50}};
    mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
    const HandMotion forward = {{0, 0, 0}, {0, 150, 0}, 0.0, 0.0, 0.0};
    const FilmBoxes boxes(mesh, forward.piece(), kReach);
    EXPECT_FALSE(boxes.of(0)) << "behind the camera";
    EXPECT_FALSE(boxes.of(1)) << "far beside the picture, and flown past";
}

// A camera that does not move, before a triangle at a depth of 100 m: its image, which is known.
TEST(FilmBox, IsTheImageWhereNothingMoves) {
    TriangleMesh mesh;
    mesh.positions = {{-20, 100, -10}, {30, 100, -10}, {0, 100, 40}};
    mesh.triangles = {{0, 1, 2}};
    MotionPiece piece = HandMotion{{0, 0, 0}, {0, 0, 0}, 0.0, 0.0, 0.0}.piece();
    piece.origin = {};
    const auto box = FilmBoxes(mesh, piece, kReach).of(0);
    ASSERT_TRUE(box);
    EXPECT_NEAR(box->low[0], -0.2 / 0.577, 1e-4);
    EXPECT_NEAR(box->high[0], 0.3 / 0.577, 1e-4);
    EXPECT_NEAR(box->low[1], -0.4 / 0.577, 1e-4);
    EXPECT_NEAR(box->high[1], 0.1 / 0.577, 1e-4);
    EXPECT_NEAR(box->low[2], 100.0, 1e-4);
    EXPECT_NEAR(box->high[2], 100.0, 1e-4);
}

}  // namespace
}  // namespace overfly
