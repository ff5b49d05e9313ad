#pragma once

#include "core/geometry.h"
#include "mesh/triangle_mesh.h"

namespace overfly {

// The plane that a mesh lies in, more or less: through the middle of its positions, across the sum of its triangles'
// areas, each counted in the direction of the largest.
struct MeshPlane {
    Point<Scene> on;
    Vector<Scene> normal;     // of unit length
    double farthest_m = 0.0;  // of the positions from the plane
    double size_m = 0.0;      // diagonal of the box around the positions

    // Whether it is as flat as a polygon has to be (polygon.h): what a mirror must be.
    [[nodiscard]] bool is_planar() const;
};

// REQUIRES: the mesh has a triangle, and none without area.
[[nodiscard]] MeshPlane plane_of(const TriangleMesh& mesh);

}  // namespace overfly
