#include "shot/pixel_tile.h"

#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace overfly {
namespace {

TEST(PixelTile, TilesCoverThePictureOnce) {
    for (const PictureSize size : {PictureSize{1, 1}, {16, 16}, {17, 33}, {160, 90}, {3, 100}}) {
        std::vector<int> covered(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
        for (const PixelTile& tile : tiles_of(size)) {
            for (int y = tile.top; y < tile.bottom; ++y) {
                for (int x = tile.left; x < tile.right; ++x) ++covered.at(static_cast<std::size_t>(y * size.width + x));
            }
        }
        EXPECT_EQ(std::set(covered.begin(), covered.end()), std::set{1}) << size.width << " x " << size.height;
    }
}

TEST(PixelTile, FilmCoordinatesHaveTheWidthFromMinusOneToOneAndSquarePixels) {
    const PictureSize size{200, 100};
    EXPECT_EQ(size.film_x(0), -1.0);
    EXPECT_EQ(size.film_x(200), 1.0);
    EXPECT_EQ(size.film_y(0), -0.5);
    EXPECT_EQ(size.film_y(100), 0.5);
}

TEST(PixelTile, SamplesLieInTheirPixels) {
    const PictureSize size{37, 21};
    for (const PixelTile& tile : tiles_of(size)) {
        const TileSamples samples = samples_of(tile, size, 5);
        ASSERT_EQ(samples.samples.size(), samples.pixels.size());
        std::map<std::uint32_t, int> count;
        for (std::size_t i = 0; i < samples.samples.size(); ++i) {
            const auto x = static_cast<int>(samples.pixels[i]) % size.width;
            const auto y = static_cast<int>(samples.pixels[i]) / size.width;
            const ImageSample& s = samples.samples[i];
            EXPECT_GE(s.x, size.film_x(x));
            EXPECT_LT(s.x, size.film_x(x + 1));
            EXPECT_GE(s.y, size.film_y(y));
            EXPECT_LT(s.y, size.film_y(y + 1));
            EXPECT_GE(s.phase, 0.0);
            EXPECT_LT(s.phase, 1.0);
            ++count[samples.pixels[i]];
        }
        EXPECT_EQ(count.size(), static_cast<std::size_t>((tile.right - tile.left) * (tile.bottom - tile.top)));
        for (const auto& [pixel, n] : count) EXPECT_EQ(n, 5) << pixel;
    }
}

TEST(PixelTile, APixelHasTheSameSamplesInAnyTile) {
    const PictureSize size{40, 24};
    const auto of_pixel = [&](const PixelTile& tile, std::uint32_t pixel) {
        std::set<std::array<double, 3>> places;
        const TileSamples samples = samples_of(tile, size, 9);
        for (std::size_t i = 0; i < samples.samples.size(); ++i) {
            const ImageSample& s = samples.samples[i];
            if (samples.pixels[i] == pixel) places.insert({s.x, s.y, s.phase});
        }
        return places;
    };
    for (const std::uint32_t pixel : {0U, 5U * 40U + 7U, 15U * 40U + 15U}) {
        const auto places = of_pixel({0, 0, 16, 16}, pixel);
        EXPECT_EQ(places.size(), 9U);
        EXPECT_EQ(of_pixel({0, 0, 40, 24}, pixel), places);
        const auto x = static_cast<int>(pixel % 40), y = static_cast<int>(pixel / 40);
        EXPECT_EQ(of_pixel({x, y, x + 1, y + 1}, pixel), places);
    }
}

}  // namespace
}  // namespace overfly
