#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "trace/silhouette_film.h"
#include "trace/visible_segment.h"

namespace overfly {

// The picture's size and how a pixel of it becomes a place on the film.
struct PictureSize {
    int width = 0, height = 0;

    [[nodiscard]] double film_x(double x_px) const { return 2.0 * x_px / width - 1.0; }
    [[nodiscard]] double film_y(double y_px) const { return (2.0 * y_px - height) / width; }
    [[nodiscard]] double film_per_px() const { return 2.0 / width; }
    [[nodiscard]] FilmBounds film_bounds() const { return {film_x(0), film_x(width), film_y(0), film_y(height)}; }
};

// A square of pixels, the unit of work of a thread.
struct PixelTile {
    int left = 0, top = 0, right = 0, bottom = 0;  // right and bottom excluded
};
inline constexpr int kTileSide_px = 16;

[[nodiscard]] std::vector<PixelTile> tiles_of(PictureSize size, int side_px = kTileSide_px);

// The image samples of a tile, and the pixel of each. Four by four neighbouring pixels with the same sample number
// follow each other, so that sixteen of them make a coherent packet.
struct TileSamples {
    std::vector<ImageSample> samples;
    std::vector<std::uint32_t> pixels;  // row by row in the whole picture
};

// per_pixel samples in each pixel, at the same places in it for every frame and any tile that holds it.
[[nodiscard]] TileSamples samples_of(const PixelTile& tile, PictureSize size, int per_pixel);

}  // namespace overfly
