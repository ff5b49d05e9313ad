#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/geometry.h"
#include "geo/frames.h"

namespace overfly {

using VertexId = std::uint32_t;
using TriangleId = std::uint32_t;

// A half-edge is 4 * triangle + k: the side of the triangle from its corner k to its corner (k + 1) % 3.
using HalfEdgeId = std::uint32_t;

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Connected triangles, in metres of the frame in which they stand still: terrain in the scene itself, a body that moves
// in a scene of its own.
// GUARANTEES (of whoever makes one): at most two triangles share a side as twins, and they run along it in opposite
// directions; twin is an involution; no triangle has a repeated corner.
struct TriangleMesh {
    std::vector<Point<Scene>> positions;
    std::vector<std::array<VertexId, 3>> triangles;
    std::vector<std::array<HalfEdgeId, 3>> twins;  // across each side, or kNone at a border

    [[nodiscard]] std::size_t memory_bytes() const {
        return positions.size() * sizeof(positions[0]) + triangles.size() * (sizeof(triangles[0]) + sizeof(twins[0]));
    }
    friend bool operator==(const TriangleMesh&, const TriangleMesh&) = default;
};

}  // namespace overfly
