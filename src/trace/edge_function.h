#pragma once

#include <array>

#include "core/geometry.h"
#include "geo/frames.h"
#include "mesh/triangle_mesh.h"

namespace overfly {

// The side on which a line passes an edge (design 3.2): for the edge a -> b and the line through o along d,
//     E = -[(a - o) x (b - o)] . d = -((a x b) . d + (b - a) . (o x d)),
// linear in the line's Pluecker coordinates (d, o x d). A line passes through a triangle where the E of its three sides
// have one sign. Two triangles that share a side evaluate it in one direction, from the lower vertex to the higher, and
// flip the sign of the result: exactly opposite values, so no line slips between them.
struct EdgeFunction {
    Vector<Scene> a_cross_b;  // of the end points, relative to the origin that o is relative to
    Vector<Scene> b_minus_a;
    double sign = 1.0;  // -1 where the triangle runs along the edge against the canonical direction

    [[nodiscard]] double at(Vector<Scene> d, Vector<Scene> o_cross_d) const {
        return -sign * (dot(a_cross_b, d) + dot(b_minus_a, o_cross_d));
    }
};

[[nodiscard]] inline EdgeFunction edge_function(VertexId from, VertexId to, Vector<Scene> at_from,
                                                Vector<Scene> at_to) {
    if (from < to) return {cross(at_from, at_to), at_to - at_from, 1.0};
    return {cross(at_to, at_from), at_from - at_to, -1.0};
}

// Of a triangle's sides, from each corner to the next, relative to `reference`.
[[nodiscard]] inline std::array<EdgeFunction, 3> edge_functions(const TriangleMesh& mesh, TriangleId triangle,
                                                                Point<Scene> reference) {
    const auto& corner = mesh.triangles[triangle];
    std::array<EdgeFunction, 3> edges;
    for (std::size_t k = 0; k < 3; ++k) {
        const VertexId a = corner[k];
        const VertexId b = corner[(k + 1) % 3];
        edges[k] = edge_function(a, b, mesh.positions[a] - reference, mesh.positions[b] - reference);
    }
    return edges;
}

// Where the line o + s d meets the plane of a triangle: s, not finite where it runs within the plane.
[[nodiscard]] inline double plane_depth(Vector<Scene> v0, Vector<Scene> v1, Vector<Scene> v2, Vector<Scene> o,
                                        Vector<Scene> d) {
    const Vector<Scene> normal = cross(v1 - v0, v2 - v0);
    return dot(normal, v0 - o) / dot(normal, d);
}

}  // namespace overfly
