#include "shot/ground_triangle.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

// A camera at (0, 0, 100) that looks straight down, its picture's right to the east, its lens 90 degrees wide; in the
// piece it flies 60 m to the east.
MotionPiece downward() {
    MotionPiece piece;
    piece.when = {0.0, 2.0};
    piece.reference = {0.0, 0.0, 100.0};
    piece.origin = {{}, {60.0, 0.0, 0.0}, {}};
    piece.right = {{1.0, 0.0, 0.0}, {}, {}};
    piece.down = {{0.0, -1.0, 0.0}, {}, {}};
    piece.view = {{0.0, 0.0, -1.0}, {}, {}};
    return piece;
}

// Level ground of 4 x 4 cells of 20 m, at half height.
GroundTriangle level() {
    return {{{0.0, 0.0, 50.0}, {10, 20}}, {{80.0, 0.0, 50.0}, {14, 20}}, {{0.0, 80.0, 50.0}, {10, 16}}};
}

TEST(GroundTriangle, IsHitInTheSceneAndInTheRaster) {
    const MotionPiece piece = downward();
    const auto hit = level().hit(piece, 0.5, piece.direction_at(0.5, 0.2, -0.4));
    EXPECT_NEAR(hit.depth_m, 50.0, 1e-12);
    // The ray comes down at (30 + 0.2 * 50, 0.4 * 50) m.
    EXPECT_NEAR(level().place(hit).column, 12.0, 1e-12);
    EXPECT_NEAR(level().place(hit).row, 19.0, 1e-12);
}

TEST(GroundTriangle, IsNotLeft) {
    const MotionPiece piece = downward();
    const auto beside = level().hit(piece, 0.0, piece.direction_at(0.0, -0.1, 0.1));
    EXPECT_EQ(level().place(beside).column, 10.0);
    EXPECT_EQ(level().place(beside).row, 20.0);
    const auto from_its_edge = level().hit(piece, 0.0, {1.0, 0.0, 0.0});
    EXPECT_GE(level().place(from_its_edge).column, 10.0);
    EXPECT_LE(level().place(from_its_edge).column, 14.0);
}

}  // namespace
}  // namespace overfly
