#include "shot/drift_axis.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

constexpr double kDrift_px = 8.0;

DriftAxis best(std::initializer_list<PictureChange> changes) {
    DriftAxisChoice choice(kDrift_px);
    for (const PictureChange& c : changes) choice.add(c);
    return choice.best();
}

TEST(DriftAxisChoice, IsOverEdgesThatStay) {
    EXPECT_EQ(best({{.right = 0.0, .down = 1.0}}), DriftAxis::Y);
    EXPECT_EQ(best({{.right = -1.0, .down = 0.0}}), DriftAxis::X);
    EXPECT_EQ(best({{.right = 0.3, .down = 1.0}, {.right = 1.0, .down = -0.3}, {.right = 0.0, .down = 0.5}}),
              DriftAxis::Y);
}

// What is equally uneven in all directions is blurred by time along the motion.
TEST(DriftAxisChoice, IsAcrossTheMotionOfEvenGround) {
    for (const double motion_px : {-20.0, -4.0, 4.0, 20.0}) {
        EXPECT_EQ(best({{.right = 1.0, .motion_right_px = motion_px}, {.down = 1.0, .motion_right_px = motion_px}}),
                  DriftAxis::Y)
            << motion_px;
        EXPECT_EQ(best({{.right = 1.0, .motion_down_px = motion_px}, {.down = 1.0, .motion_down_px = motion_px}}),
                  DriftAxis::X)
            << motion_px;
    }
}

TEST(DriftAxisChoice, LeavesEdgesToTimeThatMoveQuickly) {
    const PictureChange stays = {.down = 1.0};
    EXPECT_EQ(best({{.right = 2.0}, stays}), DriftAxis::X);
    EXPECT_EQ(best({{.right = 2.0, .motion_right_px = 60.0}, stays}), DriftAxis::Y);
}

TEST(DriftAxisChoice, IsDownwardInDoubt) {
    EXPECT_EQ(best({}), DriftAxis::Y);
    EXPECT_EQ(best({{}, {.motion_right_px = 3.0}}), DriftAxis::Y);
    EXPECT_EQ(best({{.right = 1.0, .down = 1.0}}), DriftAxis::Y);
}

}  // namespace
}  // namespace overfly
