#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "film/pixel_filter.h"
#include "trace/silhouette_film.h"
#include "trace/visible_segment.h"

namespace overfly {

// The picture's size and how a pixel of it becomes a place on the film.
struct PictureSize {
    int width = 0, height = 0;

    [[nodiscard]] double film_x(double x_px) const { return 2.0 * x_px / width - 1.0; }
    [[nodiscard]] double film_y(double y_px) const { return (2.0 * y_px - height) / width; }
    [[nodiscard]] double film_per_px() const { return 2.0 / width; }
    [[nodiscard]] FilmBounds film_bounds(double margin_px = 0.0) const {
        return {film_x(-margin_px), film_x(width + margin_px), film_y(-margin_px), film_y(height + margin_px)};
    }
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
    std::vector<double> weights;        // 1 on average in a pixel, or empty where all are
};

// per_pixel samples for each pixel, at the same places for every frame and any tile that holds it: evenly in the pixel,
// or spread around its middle by the filter.
[[nodiscard]] TileSamples samples_of(const PixelTile& tile, PictureSize size, int per_pixel,
                                     const PixelFilter* filter = nullptr);

}  // namespace overfly
