#pragma once

#include <array>
#include <cstddef>

#include "core/bernstein.h"

namespace overfly {

// A part of a cell of time, [begin, end] within [0, 1].
struct Stretch {
    double begin = 0.0, end = 1.0;
};

// Ascending and apart. Three quartics and a quadratic cut a cell into fifteen parts at most, of which every other can
// count.
struct Stretches {
    std::array<Stretch, 8> at{};
    std::size_t count = 0;

    [[nodiscard]] const Stretch* begin() const { return at.data(); }
    [[nodiscard]] const Stretch* end() const { return at.data() + count; }
};

// What a line of sight does in one cell, by polynomials in the cell's time: its side of a triangle's three edges, and
// the two parts of the depth at which it meets the triangle's plane.
struct LineInCell {
    std::array<Bernstein<4>, 3> side;
    Bernstein<2> depth_numerator, depth_denominator;
};

// When the line passes through the triangle, before the camera: the cell is cut where it changes sides and where the
// camera passes the plane, and a part counts if its middle does. Equal polynomials give equal cuts, to the bit, so two
// triangles that share an edge leave no time between them.
[[nodiscard]] Stretches inside_stretches(const LineInCell& line);

}  // namespace overfly
