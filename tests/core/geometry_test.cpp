#include "core/geometry.h"

#include <gtest/gtest.h>

#include "core/angle.h"
#include "core/error.h"

namespace overfly {
namespace {

struct A;
struct B;
struct C;

Transform<A, B> quarter_turn_and_step() { return {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, {10, 20, 30}}; }

TEST(Geometry, TransformsCompose) {
    const Transform<A, B> a_from_b = quarter_turn_and_step();
    const Transform<B, C> b_from_c = {{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, {1, 2, 3}};
    const Point<C> p = {4, 5, 6};
    EXPECT_EQ((a_from_b * b_from_c) * p, a_from_b * (b_from_c * p));
}

TEST(Geometry, InverseTakesBack) {
    const Transform<A, B> a_from_b = quarter_turn_and_step();
    const Point<B> p = {4, 5, 6};
    EXPECT_EQ(inverse(a_from_b) * (a_from_b * p), p);
    EXPECT_EQ(a_from_b * Point<B>({1, 0, 0}), (Point<A>{10, 21, 30}));
}

TEST(Geometry, CrossFollowsTheRightHand) {
    EXPECT_EQ(cross(Vector<A>{1, 0, 0}, Vector<A>{0, 1, 0}), (Vector<A>{0, 0, 1}));
}

TEST(Angle, KeepsItsUnit) {
    EXPECT_DOUBLE_EQ(Angle::degrees(180.0).radians(), std::numbers::pi);
    EXPECT_DOUBLE_EQ(Angle::radians(std::numbers::pi / 2).degrees(), 90.0);
}

TEST(Error, SaysPlaceAndMessage) {
    const UserError error({{{"a.yaml", 3, 7}, "one"}, {{"b.tif"}, "two"}, {{}, "three"}});
    EXPECT_STREQ(error.what(), "a.yaml:3:7: one\nb.tif: two\nthree");
}

}  // namespace
}  // namespace overfly
