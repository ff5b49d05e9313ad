#include "film/film_frame.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

TEST(FilmFrame, IsBlackAndWithoutDepthBeforeItIsExposed) {
    const Frame frame = FilmFrame(3, 2).develop().frame;
    EXPECT_EQ(frame.width, 3);
    EXPECT_EQ(frame.height, 2);
    ASSERT_EQ(frame.rgba.size(), 6U);
    ASSERT_EQ(frame.depth_m.size(), 6U);
    for (const auto& pixel : frame.rgba) EXPECT_EQ(pixel, (std::array<float, 4>{}));
    for (const float depth_m : frame.depth_m) EXPECT_EQ(depth_m, Frame::kNoDepth);
}

TEST(FilmFrame, AddsColourAndAlphaByWeight) {
    FilmFrame film(2, 2);
    film.add(3, 0.25F, {{4.0F, 8.0F, 0.0F}, 1.0F, 100.0F});
    film.add(3, 0.5F, {{0.0F, 2.0F, 6.0F}, 0.5F, 100.0F});
    const Frame frame = std::move(film).develop().frame;
    EXPECT_EQ(frame.rgba[frame.index(1, 1)], (std::array{1.0F, 3.0F, 3.0F, 0.5F}));
    EXPECT_EQ(frame.rgba[frame.index(0, 1)], (std::array<float, 4>{}));
}

TEST(FilmFrame, KeepsTheNearestDepthWhateverItsWeight) {
    FilmFrame film(1, 1);
    film.add(0, 0.5F, {{}, 1.0F, 700.0F});
    film.add(0, 0.001F, {{}, 1.0F, 300.0F});
    film.add(0, 0.499F, {{}, 1.0F, Frame::kNoDepth});
    EXPECT_EQ(std::move(film).develop().frame.depth_m[0], 300.0F);
}

}  // namespace
}  // namespace overfly
