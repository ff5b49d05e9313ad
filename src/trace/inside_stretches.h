#pragma once

#include <array>
#include <cstddef>

#include "core/bernstein.h"
#include "trace/stretches.h"

namespace overfly {

// What a line does in one cell, by polynomials in the cell's time: its side of a triangle's three edges, and the two
// parts of the depth along it at which it meets the triangle's plane.
template <std::size_t kSide, std::size_t kDepth>
struct PolynomialLineInCell {
    std::array<Bernstein<kSide>, 3> side;
    Bernstein<kDepth> depth_numerator;
};

// Three polynomials for the sides and one for the plane cut a cell.
template <std::size_t kSide, std::size_t kDepth>
using InsideStretches = Stretches<(3 * kSide + kDepth) / 2 + 1>;

// When the line passes through the triangle, before the place where it starts: the cell is cut where it changes sides
// and where that place passes the plane, and a part counts if its middle does. Equal polynomials give equal cuts, to
// the bit, so two triangles that share an edge leave no time between them.
template <std::size_t kSide, std::size_t kDepth>
[[nodiscard]] InsideStretches<kSide, kDepth> inside_stretches(const PolynomialLineInCell<kSide, kDepth>& line);

// A line of sight; a line towards a sun that stands still, from a point that a line of sight meets; and towards one
// that turns.
using LineInCell = PolynomialLineInCell<4, 2>;
using SunLineInCell = PolynomialLineInCell<4, 4>;
using TurningSunLineInCell = PolynomialLineInCell<6, 4>;

extern template InsideStretches<4, 2> inside_stretches<4, 2>(const LineInCell&);
extern template InsideStretches<4, 4> inside_stretches<4, 4>(const SunLineInCell&);
extern template InsideStretches<6, 4> inside_stretches<6, 4>(const TurningSunLineInCell&);

}  // namespace overfly
