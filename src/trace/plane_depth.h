#pragma once

#include <cmath>

#include "core/bernstein.h"
#include "trace/swept_ray.h"

namespace overfly {

// The depth at which a line of sight meets the plane of one triangle, as a function of the time u within the piece:
// s(u) = numerator / denominator, both quadratic (Chapman, Calvert and Dill 1991, section 4: s = -(N.Ro + D) / N.Rd).
struct PlaneDepth {
    std::array<double, 3> numerator{}, denominator{};  // monomial coefficients in u

    PlaneDepth() = default;
    PlaneDepth(const TriangleMesh& mesh, TriangleId triangle, const MotionPiece& piece, double x, double y) {
        const auto& corner = mesh.triangles[triangle];
        const Vector<Scene> v0 = mesh.positions[corner[0]] - piece.reference;
        const Vector<Scene> normal = cross(mesh.positions[corner[1]] - mesh.positions[corner[0]],
                                           mesh.positions[corner[2]] - mesh.positions[corner[0]]);
        numerator = {dot(normal, v0 - piece.origin.c0), -dot(normal, piece.origin.c1), -dot(normal, piece.origin.c2)};
        denominator = {dot(normal, x * piece.right.c0 + y * piece.down.c0 + piece.view.c0),
                       dot(normal, x * piece.right.c1 + y * piece.down.c1 + piece.view.c1),
                       dot(normal, x * piece.right.c2 + y * piece.down.c2 + piece.view.c2)};
    }

    [[nodiscard]] double at(double u) const {
        return (numerator[0] + u * (numerator[1] + u * numerator[2])) /
               (denominator[0] + u * (denominator[1] + u * denominator[2]));
    }
    [[nodiscard]] Bernstein<2> numerator_in(const TimeCells& cells, std::size_t cell) const {
        return cells.coefficients(numerator[0], numerator[1], numerator[2], cell);
    }
    [[nodiscard]] Bernstein<2> denominator_in(const TimeCells& cells, std::size_t cell) const {
        return cells.coefficients(denominator[0], denominator[1], denominator[2], cell);
    }
};

}  // namespace overfly
