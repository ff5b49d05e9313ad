#pragma once

#include <bit>
#include <cstdint>

#include "terrain/terrain_mesh.h"

namespace overfly {

// The corners of a grid's cell in a ring, which runs anticlockwise seen from above where rows go south and columns
// east: 0 is the cell's first sample, 1 the one below it, 2 the opposite one, 3 the one beside it. Side s runs from
// corner s to corner s + 1. Every triangle of a cell has two of its sides and a diagonal: corners s, s + 1, s + 2. So a
// cell is said in four bits: bit s stands for the triangle that starts at corner s. Corners count modulo 4.
using CellTriangles = std::uint8_t;
inline constexpr CellTriangles kNothing = 0b0000;
inline constexpr CellTriangles kDiagonalFromFirst = 0b0101;
inline constexpr CellTriangles kDiagonalFromSecond = 0b1010;

[[nodiscard]] constexpr CellTriangles triangle_without(unsigned corner) {
    return static_cast<CellTriangles>(1U << ((corner + 1) & 3U));
}
[[nodiscard]] constexpr bool has_start(CellTriangles cell, unsigned corner) {
    return (cell >> (corner & 3U) & 1U) != 0U;
}
[[nodiscard]] constexpr TriangleId triangle_count(CellTriangles cell) {
    return static_cast<TriangleId>(std::popcount(cell));
}

// A mirrored raster's ring runs clockwise: its triangles are turned over, corners a, b, c becoming a, c, b. Their sides
// a-b, b-c, c-a then come in reverse, so that side k becomes side 2 - k.
[[nodiscard]] constexpr unsigned turned(unsigned k, bool is_mirrored) { return is_mirrored ? 2 - k : k; }

// The half-edge along a side of a cell whose first triangle is `first`; kNone where no triangle has that side.
[[nodiscard]] constexpr HalfEdgeId half_edge(CellTriangles cell, TriangleId first, unsigned side, bool is_mirrored) {
    unsigned start = side, k = 0;
    if (!has_start(cell, start)) {
        start = (side + 3) & 3U;
        k = 1;
        if (!has_start(cell, start)) return kNone;
    }
    const auto before = static_cast<CellTriangles>(cell & ((1U << start) - 1U));
    return 4 * (first + triangle_count(before)) + turned(k, is_mirrored);
}

}  // namespace overfly
