#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "film/pixel_filter.h"
#include "flight/exposure.h"

namespace overfly {

// What pixels get of the light along a line of sight during a run at an even speed, where the shutter or the pixels'
// filter weighs some of it more than other. The run is cut into cells in which both are nearly straight, and light is
// too; v is 0 where the run begins and 1 where it ends.
struct RunShares {
    // A pixel gets the cell's mean light times `whole`, and `growth` times what light grows by in the cell.
    struct Share {
        std::uint32_t pixel = 0;
        float whole = 0.0F, growth = 0.0F;
        bool is_inside = true;  // the line is in the pixel meanwhile, not only near it
    };
    struct Cell {
        float end_v = 1.0F;
        std::uint32_t end_share = 0;  // its shares end before this one
    };
    // A filter looks at several rows of pixels: all of that goes to each, by the row's weight.
    struct Row {
        std::int32_t offset = 0;  // of its pixels in the film
        float weight = 1.0F;
        bool is_inside = true;
    };
    std::vector<Cell> cells;
    std::vector<Share> shares;
    std::vector<Row> rows;
};

// A run: where it is among the pixels, and in the exposure. The pixels that may get light are those from `first` on in
// rows from `first_row` on, the ends excluded; the line moves along the rows.
struct Sweep {
    double from_px = 0.0, length_px = 0.0;  // along; none: the line is at rest
    double across_px = 0.5;                 // its place among the rows
    double from_part = 0.0, to_part = 1.0;  // of the exposure's time
    double weight = 1.0;                    // of a line that has all of the exposure
    int first = 0, end = 1;
    int first_row = 0, end_row = 1;
    std::uint32_t first_pixel = 0;  // of the first row in the film
    std::int32_t stride = 1, row_stride = 1;
};

// Weighs runs by a shutter and a filter. GUARANTEES, but for rounding: the shares of a cell are what the shutter lets
// through while it lasts, times the filter's mean over the cell along the way, and what it is across. With them light
// is integrated exactly where it is straight in each cell, with a box or trapezoid for the shutter, and a box or tent
// of usual width for the filter; with others to some 1e-3 of what the light grows by in a cell, half a pixel at most.
class RunWeighing {
  public:
    // filter: the box of one pixel if there is none; must outlive it.
    RunWeighing(const ShutterCurve& curve, const PixelFilter* filter) : curve_(curve), filter_(filter) {}

    // Whether every part of a run counts alike, so that nobody needs this.
    [[nodiscard]] bool is_even() const { return curve_.is_box() && filter_ == nullptr; }
    // Until the next call. REQUIRES: the run lasts for some time; a line at rest, or without a
    // filter, is in one of the pixels all the time and weighs there alone.
    [[nodiscard]] const RunShares& of(const Sweep& sweep);

  private:
    struct End;
    void weigh_rows(const Sweep& sweep);
    void cut(const Sweep& sweep);
    void add_cell(const Sweep& sweep, const End& from, const End& to);
    void add_filtered(const Sweep& sweep, const End& from, const End& to);

    ShutterCurve curve_;
    const PixelFilter* filter_;
    std::vector<double> cuts_v_;
    RunShares out_;
};

}  // namespace overfly
