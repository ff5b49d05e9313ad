#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/bernstein.h"
#include "flight/motion.h"
#include "mesh/triangle_mesh.h"

namespace overfly {

// From which side the camera sees a triangle while a motion piece lasts. Front is the side on which the corners run
// anticlockwise.
enum class Facing : std::uint8_t { Front, Back, Changes };

// How high the camera is over the plane of a triangle, times twice the triangle's area, as a polynomial in the piece's
// u; positive in front.
[[nodiscard]] Bernstein<2> height_over_plane(const TriangleMesh& mesh, TriangleId triangle, const MotionPiece& piece);

// Of one triangle. Front and Back are certain, from Bernstein coefficients; what they leave open is Changes, even if it
// does not.
[[nodiscard]] Facing facing_over(const TriangleMesh& mesh, TriangleId triangle, const MotionPiece& piece);

// The sides without a neighbour, ascending.
[[nodiscard]] std::vector<HalfEdgeId> border_edges(const TriangleMesh& mesh);

// The edges across which the surface that the camera sees may end at some time of the piece: borders, and those between
// triangles that it does not surely see from the same side all through. Each edge once.
[[nodiscard]] std::vector<HalfEdgeId> silhouette_edges(const TriangleMesh& mesh, std::span<const HalfEdgeId> borders,
                                                       std::span<const Facing> facing);

// The times at which the camera passes through the surface, ascending, in u: then everything may change at once.
// A passage within a millionth of a triangle's size of an edge counts for both sides.
[[nodiscard]] std::vector<double> surface_passages(const TriangleMesh& mesh, std::span<const Facing> facing,
                                                   const MotionPiece& piece);

}  // namespace overfly
