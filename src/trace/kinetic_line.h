#pragma once

#include <array>

#include "core/bernstein.h"
#include "flight/motion.h"
#include "trace/edge_function.h"

namespace overfly {

// A quadratic vector of u, and the cross product of two of them, by Bernstein coefficients.
[[nodiscard]] inline std::array<Vector<Scene>, 3> coefficients(const QuadraticVector& q) {
    return {q.c0, q.c0 + 0.5 * q.c1, q.c0 + (q.c1 + q.c2)};
}
[[nodiscard]] inline std::array<Vector<Scene>, 5> cross_coefficients(const QuadraticVector& first,
                                                                     const QuadraticVector& second) {
    const auto a = coefficients(first);
    const auto b = coefficients(second);
    return {cross(a[0], b[0]), 0.5 * (cross(a[0], b[1]) + cross(a[1], b[0])),
            (cross(a[0], b[2]) + 4.0 * cross(a[1], b[1]) + cross(a[2], b[0])) / 6.0,
            0.5 * (cross(a[1], b[2]) + cross(a[2], b[1])), cross(a[2], b[2])};
}

// The Pluecker coordinates (d, o x d) of a line of sight all through a motion piece: Bernstein coefficients in the
// piece's u, relative to its reference.
struct LineOverPiece {
    std::array<Vector<Scene>, 5> direction, moment;

    // On which side of an edge the line is when. Neighbours that share the edge get exactly opposite coefficients.
    [[nodiscard]] Bernstein<4> side_of(const EdgeFunction& edge) const {
        Bernstein<4> side{};
        for (std::size_t j = 0; j < 5; ++j) side[j] = edge.at(direction[j], moment[j]);
        return side;
    }
};

// All lines of a piece: that of the film point (x, y) is x * right + y * down + view, part by part.
struct LinesOverPiece {
    LineOverPiece right, down, view;

    LinesOverPiece() = default;
    explicit LinesOverPiece(const MotionPiece& piece)
        : right(part(piece.origin, piece.right)),
          down(part(piece.origin, piece.down)),
          view(part(piece.origin, piece.view)) {}

    [[nodiscard]] LineOverPiece at(double x, double y) const {
        LineOverPiece line;
        for (std::size_t j = 0; j < 5; ++j) {
            line.direction[j] = x * right.direction[j] + y * down.direction[j] + view.direction[j];
            line.moment[j] = x * right.moment[j] + y * down.moment[j] + view.moment[j];
        }
        return line;
    }

  private:
    [[nodiscard]] static LineOverPiece part(const QuadraticVector& origin, const QuadraticVector& direction) {
        const auto d = coefficients(direction);
        return {{d[0], 0.5 * (d[0] + d[1]), (d[0] + 4.0 * d[1] + d[2]) / 6.0, 0.5 * (d[1] + d[2]), d[2]},
                cross_coefficients(origin, direction)};
    }
};

}  // namespace overfly
