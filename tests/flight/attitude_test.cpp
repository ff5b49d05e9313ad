#include "flight/attitude.h"

#include <gtest/gtest.h>

#include "flights.h"

namespace overfly {
namespace {

using flights::deg;

const Rotation<Scene, Scene> kLevel;  // east, north, up

void expect_near(Vector<Scene> a, Vector<Scene> b) { EXPECT_LT(length(a - b), 1e-12); }

TEST(Attitude, LevelNorthIsEastRightDownDownNorthAhead) {
    const Rotation<Scene, Camera> r = orientation({}, kLevel);
    expect_near(r.x, {1, 0, 0});
    expect_near(r.y, {0, 0, -1});
    expect_near(r.z, {0, 1, 0});
}

TEST(Attitude, HeadingIsClockwiseAndPitchUp) {
    expect_near(orientation({deg(90.0), deg(0.0), deg(0.0)}, kLevel).z, {1, 0, 0});
    const double c = std::cos(deg(30.0).radians());
    expect_near(orientation({deg(0.0), deg(30.0), deg(0.0)}, kLevel).z, {0, c, 0.5});
}

TEST(Attitude, RollIsRightWingDown) {
    const Rotation<Scene, Camera> r = orientation({deg(0.0), deg(0.0), deg(10.0)}, kLevel);
    EXPECT_LT(r.x.z, 0.0);
    expect_near(r.x, {std::cos(deg(10.0).radians()), 0, -std::sin(deg(10.0).radians())});
    expect_near(r.z, {0, 1, 0});
    // A point of the horizon to the right of the view is seen above the middle of the picture (y is down): the horizon
    // is tilted anticlockwise.
    const Vector<Camera> right_horizon = inverse(r) * Vector<Scene>{1, 5, 0};
    EXPECT_GT(right_horizon.x, 0.0);
    EXPECT_LT(right_horizon.y, 0.0);
}

TEST(Attitude, StraightDownHeadingIsTheTopOfThePicture) {
    const Rotation<Scene, Camera> r = orientation({deg(90.0), deg(-90.0), deg(0.0)}, kLevel);
    expect_near(r.z, {0, 0, -1});
    expect_near(-r.y, {1, 0, 0});
    expect_near(r.x, {0, -1, 0});
}

TEST(Attitude, IsRightHanded) {
    const Rotation<Scene, Camera> r = orientation({deg(123.0), deg(-34.0), deg(56.0)}, kLevel);
    expect_near(cross(r.x, r.y), r.z);
}

TEST(Attitude, TowardsADirectionLooksAlongIt) {
    const Vector<Scene> direction = normalized(Vector<Scene>{-3, 2, -1});
    expect_near(orientation(attitude_towards(direction, kLevel), kLevel).z, direction);
    EXPECT_EQ(attitude_towards({0, 0, -5}, kLevel).pitch.degrees(), -90.0);
    EXPECT_EQ(attitude_towards({}, kLevel), Attitude{});
}

TEST(Attitude, NearestTurn) {
    EXPECT_NEAR(nearest_turn(deg(10.0), deg(350.0)).degrees(), 370.0, 1e-12);
    EXPECT_NEAR(nearest_turn(deg(350.0), deg(-20.0)).degrees(), -10.0, 1e-12);
    EXPECT_NEAR(nearest_turn(deg(750.0), deg(0.0)).degrees(), 30.0, 1e-12);
}

}  // namespace
}  // namespace overfly
