#include "io/display.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

DisplayImage shown(std::array<float, 4> rgba) {
    return display_image(Frame{.width = 1, .height = 1, .rgba = {rgba}, .depth_m = {1.0F}});
}

TEST(SoftHighlight, KeepsWhatIsNotAHighlight) {
    for (const float v : {0.0F, 0.18F, 0.5F, 0.8F}) EXPECT_EQ(soft_highlight(v), v);
    EXPECT_EQ(soft_highlight(-0.1F), 0.0F);
}

TEST(SoftHighlight, RisesToOneWithoutAKink) {
    float last = soft_highlight(0.8F);
    for (float v = 0.81F; v < 1.5F; v += 0.01F) {
        const float now = soft_highlight(v);
        EXPECT_GT(now, last);
        EXPECT_LT(now - last, 0.0101F);
        last = now;
    }
    EXPECT_LE(soft_highlight(1e6F), 1.0F);
    EXPECT_NEAR(soft_highlight(0.8F + 1e-3F) - 0.8F, 1e-3F, 1e-5F);
}

TEST(Display, IsSrgb) {
    // Reference values of IEC 61966-2-1: 18 % grey is 118 (117.7), 50 % is 188 (187.5).
    EXPECT_EQ(shown({0.18F, 0.5F, 0.0F, 1.0F}).rgb, (std::vector<std::uint8_t>{118, 188, 0}));
    EXPECT_EQ(shown({100.0F, -1.0F, 0.0031308F, 1.0F}).rgb, (std::vector<std::uint8_t>{255, 0, 10}));
}

}  // namespace
}  // namespace overfly
