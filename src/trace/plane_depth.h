#pragma once

#include <cmath>

#include "core/bernstein.h"
#include "trace/swept_ray.h"

namespace overfly {

// The depth at which a line of sight meets a plane, as a function of the time u within the piece: s(u) = numerator /
// denominator, both quadratic (Chapman, Calvert and Dill 1991, section 4: s = -(N.Ro + D) / N.Rd).
struct PlaneDepth {
    std::array<double, 3> numerator{}, denominator{};  // monomial coefficients in u

    PlaneDepth() = default;
    // Of the plane through `on`.
    PlaneDepth(Point<Scene> on, Vector<Scene> normal, const MotionPiece& piece, double x, double y) {
        const Vector<Scene> v0 = on - piece.reference;
        numerator = {dot(normal, v0 - piece.origin.c0), -dot(normal, piece.origin.c1), -dot(normal, piece.origin.c2)};
        denominator = {dot(normal, x * piece.right.c0 + y * piece.down.c0 + piece.view.c0),
                       dot(normal, x * piece.right.c1 + y * piece.down.c1 + piece.view.c1),
                       dot(normal, x * piece.right.c2 + y * piece.down.c2 + piece.view.c2)};
    }
    // Of a triangle's plane.
    PlaneDepth(const TriangleMesh& mesh, TriangleId triangle, const MotionPiece& piece, double x, double y)
        : PlaneDepth(mesh.positions[mesh.triangles[triangle][0]], normal_of(mesh, triangle), piece, x, y) {}

    [[nodiscard]] double at(double u) const {
        return (numerator[0] + u * (numerator[1] + u * numerator[2])) /
               (denominator[0] + u * (denominator[1] + u * denominator[2]));
    }
    // Over a stretch of the piece.
    [[nodiscard]] Bernstein<2> numerator_over(double from, double to) const {
        return quadratic_over(numerator[0], numerator[1], numerator[2], from, to);
    }
    [[nodiscard]] Bernstein<2> denominator_over(double from, double to) const {
        return quadratic_over(denominator[0], denominator[1], denominator[2], from, to);
    }
    [[nodiscard]] Bernstein<2> numerator_in(const TimeCells& cells, std::size_t cell) const {
        return numerator_over(cells.from[cell], cells.to[cell]);
    }
    [[nodiscard]] Bernstein<2> denominator_in(const TimeCells& cells, std::size_t cell) const {
        return denominator_over(cells.from[cell], cells.to[cell]);
    }

    // As long as twice the area of the triangle.
    [[nodiscard]] static Vector<Scene> normal_of(const TriangleMesh& mesh, TriangleId triangle) {
        const auto& corner = mesh.triangles[triangle];
        return cross(mesh.positions[corner[1]] - mesh.positions[corner[0]],
                     mesh.positions[corner[2]] - mesh.positions[corner[0]]);
    }
};

}  // namespace overfly
