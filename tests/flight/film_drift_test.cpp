#include "flight/film_drift.h"

#include <gtest/gtest.h>

#include <array>

#include "support/motions.h"

namespace overfly {
namespace {

// Half a radian of turn in a piece is far more than fit_motion lets pass.
const testing::HandMotion kTurning = {{10.0, -2000.0, 1500.0}, {200.0, 50.0, -30.0}, 0.1, -0.5, 0.5};
constexpr double kWidth_px = 960.0;
constexpr double kFilmPerPixel = 2.0 / kWidth_px;

Point<Scene> on_ray(const MotionPiece& piece, double u, double x, double y, double depth_m) {
    return piece.origin_at(u) + depth_m * piece.direction_at(u, x, y);
}

TEST(FilmPoint, IsWhereTheRayIs) {
    const MotionPiece piece = kTurning.piece();
    for (const double u : {0.0, 0.3, 1.0}) {
        const FilmPoint p = film_point(piece, u, on_ray(piece, u, -0.7, 0.4, 3210.0));
        EXPECT_NEAR(p.x, -0.7, 1e-12);
        EXPECT_NEAR(p.y, 0.4, 1e-12);
        EXPECT_NEAR(p.depth_m, 3210.0, 1e-8);
    }
    EXPECT_LT(film_point(piece, 0.5, on_ray(piece, 0.5, 0.1, 0.2, -5.0)).depth_m, 0.0);
}

// The drifting piece's ray of (x, y) is the piece's own ray of the place that the sample has come to.
TEST(Drifting, FollowsASampleAcrossTheFilm) {
    const MotionPiece piece = kTurning.piece();
    const double drift_px = 30.0;
    for (const auto& [x_px, y_px] : {std::array{drift_px, 0.0}, std::array{0.0, -drift_px}}) {
        const FilmDrift drift = {x_px * kFilmPerPixel, y_px * kFilmPerPixel, 0.4};
        const MotionPiece moved = drifting(piece, drift);
        for (const double t : {0.0, 0.2, 0.4, 0.75, 1.0}) {
            for (const double x : {-1.0, 0.1, 0.9}) {
                const FilmPoint at = film_point(piece, t, on_ray(moved, t, x, 0.3, 1000.0));
                EXPECT_NEAR((at.x - x) / kFilmPerPixel, (t - 0.4) * x_px, 0.15);
                EXPECT_NEAR((at.y - 0.3) / kFilmPerPixel, (t - 0.4) * y_px, 0.15);
            }
        }
    }
}

// As the header says: a turn of 10 degrees.
TEST(Drifting, IsWithinTwoHundredthsOfAPixelInAnyPieceThatPasses) {
    testing::HandMotion slower = kTurning;
    slower.turn_rad = 0.175;
    const MotionPiece piece = slower.piece();
    const MotionPiece moved = drifting(piece, {30.0 * kFilmPerPixel, 0.0, 0.5});
    for (double t = 0.0; t <= 1.0; t += 0.05) {
        const FilmPoint at = film_point(piece, t, on_ray(moved, t, 0.8, 0.3, 1000.0));
        EXPECT_NEAR((at.x - 0.8) / kFilmPerPixel, (t - 0.5) * 30.0, 0.02);
        EXPECT_NEAR((at.y - 0.3) / kFilmPerPixel, 0.0, 0.02);
    }
}

TEST(Drifting, WithoutDriftIsTheSamePiece) {
    const MotionPiece piece = kTurning.piece();
    const MotionPiece moved = drifting(piece, {0.0, 0.0, 0.3});
    EXPECT_EQ(moved.direction_at(0.7, 0.2, 0.1), piece.direction_at(0.7, 0.2, 0.1));
    EXPECT_EQ(moved.origin_at(0.7), piece.origin_at(0.7));
}

TEST(PartOf, IsTheSameRaysForAWhile) {
    const MotionPiece piece = kTurning.piece();
    const TimeRange when = {piece.time_at(0.3), piece.time_at(0.45)};
    const MotionPiece part = part_of(piece, when);
    EXPECT_EQ(part.when.begin_s, when.begin_s);
    EXPECT_EQ(part.when.end_s, when.end_s);
    for (double t = when.begin_s; t <= when.end_s; t += 0.01) {
        const double u = piece.u_at(t), v = part.u_at(t);
        EXPECT_NEAR(length(part.direction_at(v, -0.4, 0.3) - piece.direction_at(u, -0.4, 0.3)), 0.0, 1e-14);
        EXPECT_NEAR(length(part.origin_at(v) - piece.origin_at(u)), 0.0, 1e-9);
    }
}

TEST(StandingStill, IsTheOneTimeForAll) {
    const MotionPiece piece = kTurning.piece();
    const MotionPiece still = standing_still(piece, 0.3, {5.0, 7.0});
    EXPECT_EQ(still.when, (TimeRange{5.0, 7.0}));
    for (const double u : {0.0, 0.5, 1.0}) {
        EXPECT_EQ(still.direction_at(u, 0.2, -0.1), piece.direction_at(0.3, 0.2, -0.1));
        EXPECT_EQ(still.origin_at(u), piece.origin_at(0.3));
    }
}

}  // namespace
}  // namespace overfly
