#include "shot/pixel_tile.h"

#include <algorithm>

#include "core/low_discrepancy.h"

namespace overfly {
namespace {

constexpr int kBlockSide_px = 4;  // of a packet of sixteen rays

}  // namespace

std::vector<PixelTile> tiles_of(PictureSize size, int side_px) {
    std::vector<PixelTile> tiles;
    for (int top = 0; top < size.height; top += side_px) {
        for (int left = 0; left < size.width; left += side_px) {
            tiles.push_back({left, top, std::min(left + side_px, size.width), std::min(top + side_px, size.height)});
        }
    }
    return tiles;
}

TileSamples samples_of(const PixelTile& tile, PictureSize size, int per_pixel, const PixelFilter* filter) {
    const auto place = [&](double in_pixel) {
        return per_pixel < kPlacesForLobes ? filter->place_above_zero(in_pixel) : filter->place(in_pixel);
    };
    std::vector<SobolPoint> points;
    for (int i = 0; i < per_pixel; ++i) points.push_back(sobol_point(static_cast<std::uint32_t>(i)));
    struct Pixel {
        int x, y;
        std::uint32_t index;
        AxisScramble scramble;
    };
    TileSamples out;
    std::vector<Pixel> block;
    for (int top = tile.top; top < tile.bottom; top += kBlockSide_px) {
        for (int left = tile.left; left < tile.right; left += kBlockSide_px) {
            block.clear();
            for (int y = top; y < std::min(top + kBlockSide_px, tile.bottom); ++y) {
                for (int x = left; x < std::min(left + kBlockSide_px, tile.right); ++x) {
                    const auto index = static_cast<std::uint32_t>(y * size.width + x);
                    block.push_back({x, y, index, AxisScramble(index)});
                }
            }
            for (const SobolPoint& point : points) {
                for (const Pixel& pixel : block) {
                    const auto p = scrambled(point, pixel.scramble);
                    out.pixels.push_back(pixel.index);
                    if (filter == nullptr) {
                        out.samples.push_back({size.film_x(pixel.x + p[0]), size.film_y(pixel.y + p[1]), p[2]});
                        continue;
                    }
                    const PixelFilter::Place x = place(p[0]), y = place(p[1]);
                    out.samples.push_back(
                        {size.film_x(pixel.x + 0.5 + x.x_px), size.film_y(pixel.y + 0.5 + y.x_px), p[2]});
                    out.weights.push_back(x.weight * y.weight);
                }
            }
        }
    }
    return out;
}

}  // namespace overfly
