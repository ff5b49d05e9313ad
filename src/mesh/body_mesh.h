#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/polygon.h"
#include "mesh/triangle_mesh.h"

namespace overfly {

// The surface of a body, in metres of the body: x to its right, y forward, z up (geo/frames.h).
struct BodyMesh {
    TriangleMesh mesh;
    std::size_t dropped_degenerate = 0;  // triangles that have no area; polygons of a file that cross themselves, too
    std::size_t skipped_other = 0;       // points and lines of a file
};

// Joins positions that are the same to the last bit, drops triangles without area and positions without triangle, and
// connects what is left. The triangles keep their order and direction.
// REQUIRES: all positions finite; fewer than 2^30 triangles.
[[nodiscard]] BodyMesh body_mesh_of(std::span<const Point<Scene>> positions,
                                    std::span<const std::array<VertexId, 3>> triangles);

// The same of polygons. REQUIRES: polygon_fault finds nothing wrong with any.
[[nodiscard]] BodyMesh body_mesh_of(std::span<const Polygon> polygons);

}  // namespace overfly
