#pragma once

#include <array>

#include "trace/edge_function.h"

namespace overfly {

// A line of sight at one instant, in double, relative to a reference point near the camera.
struct Line {
    Point<Scene> reference;
    Vector<Scene> origin, direction;
};

// The values of the edge functions of a triangle's sides for the line; of one sign where it passes through.
struct EdgeValues {
    std::array<double, 3> at{};

    [[nodiscard]] bool inside() const {
        return (at[0] >= 0.0 && at[1] >= 0.0 && at[2] >= 0.0) || (at[0] <= 0.0 && at[1] <= 0.0 && at[2] <= 0.0);
    }
};

[[nodiscard]] inline EdgeValues edge_values(const TriangleMesh& mesh, TriangleId triangle, const Line& line) {
    const auto& corner = mesh.triangles[triangle];
    const Vector<Scene> moment = cross(line.origin, line.direction);
    EdgeValues values;
    for (std::size_t k = 0; k < 3; ++k) {
        const VertexId a = corner[k];
        const VertexId b = corner[(k + 1) % 3];
        const EdgeFunction e =
            edge_function(a, b, mesh.positions[a] - line.reference, mesh.positions[b] - line.reference);
        values.at[k] = e.at(line.direction, moment);
    }
    return values;
}

// Where the line meets the plane of the triangle; not finite where it runs within it.
[[nodiscard]] inline double depth_on(const TriangleMesh& mesh, TriangleId triangle, const Line& line) {
    const auto& corner = mesh.triangles[triangle];
    return plane_depth(mesh.positions[corner[0]] - line.reference, mesh.positions[corner[1]] - line.reference,
                       mesh.positions[corner[2]] - line.reference, line.origin, line.direction);
}

}  // namespace overfly
