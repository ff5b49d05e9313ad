#include "io/display.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

DisplayImage shown(std::array<float, 4> rgba) {
    return display_image(Frame{.width = 1, .height = 1, .rgba = {rgba}, .depth_m = {1.0F}});
}

TEST(Display, IsSrgb) {
    // Reference values of IEC 61966-2-1: 18 % grey is 118 (117.7), 50 % is 188 (187.5).
    EXPECT_EQ(shown({0.18F, 0.5F, 0.0F, 1.0F}).rgb, (std::vector<std::uint8_t>{118, 188, 0}));
    EXPECT_EQ(shown({100.0F, -1.0F, 0.0031308F, 1.0F}).rgb, (std::vector<std::uint8_t>{255, 0, 10}));
}

}  // namespace
}  // namespace overfly
