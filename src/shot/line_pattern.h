#pragma once

#include <cstdint>
#include <vector>

#include "shot/pixel_tile.h"
#include "trace/visible_segment.h"

namespace overfly {

// The axis of the picture along which image samples drift.
enum class DriftAxis { X, Y };

// Where lines of sight are that drift over the picture: in the middle of an exposure each is at its home. On every row
// of pixels (every column, where they drift along y) homes stand at even distances, `per_pixel` to a pixel and on over
// the picture's edges, so that all the time each pixel has as many lines in it; and the places of successive ones
// across the row are stratified (van der Corput's sequence, scrambled by row), so that the lines that pass through one
// pixel while the shutter is open fill it evenly. The same for every frame.
struct LinePattern {
    PictureSize size;
    DriftAxis axis = DriftAxis::X;
    int per_pixel = 2;
    int set = 0;  // other lines for each
};

// A part of the pattern: rows, or columns, and a stretch of them along the drift, both in pixels.
struct HomeRange {
    int first_row = 0, end_row = 0;  // end excluded
    double from_px = 0.0, to_px = 0.0;
};

struct DriftingLine {
    int row = 0;  // of pixels; column, where the drift is along y
    double home_px = 0.0;
    double across_px = 0.0;              // from the row's own begin, in [0, 1)
    std::uint32_t number = 0, seed = 0;  // of the line in its row, and of the row

    // Another number in [0, 1), stratified with across_px.
    [[nodiscard]] double phase() const;
};

// In an order in which sixteen that follow each other lie close together.
[[nodiscard]] std::vector<DriftingLine> lines_of(const LinePattern& pattern, const HomeRange& range);

// The image sample that passes the line's home shift_px before its time.
[[nodiscard]] ImageSample sample_of(const LinePattern& pattern, const DriftingLine& line, double shift_px);

}  // namespace overfly
