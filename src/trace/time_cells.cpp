#include "trace/time_cells.h"

#include <algorithm>

namespace overfly {
namespace {

using QuadraticBernstein = std::array<Bernstein<2>, 3>;  // by axis

QuadraticBernstein coefficients_of(const QuadraticVector& q, std::size_t cell) {
    return {cell_coefficients(q.c0.x, q.c1.x, q.c2.x, cell), cell_coefficients(q.c0.y, q.c1.y, q.c2.y, cell),
            cell_coefficients(q.c0.z, q.c1.z, q.c2.z, cell)};
}

Bernstein<4> raised(const Bernstein<2>& b) { return b * Bernstein<2>{1.0, 1.0, 1.0}; }

void set(QuarticVectors& vectors, std::size_t axis, std::size_t cell, const Bernstein<4>& b) {
    for (std::size_t j = 0; j < 5; ++j) vectors[axis][j][cell] = b[j];
}

void set_part(CellLines& part, std::size_t cell, const QuadraticBernstein& origin,
              const QuadraticBernstein& direction) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t next = (axis + 1) % 3;
        const std::size_t last = (axis + 2) % 3;
        const Bernstein<4> plus = origin[next] * direction[last];
        const Bernstein<4> minus = origin[last] * direction[next];
        Bernstein<4> moment{};
        for (std::size_t j = 0; j < 5; ++j) moment[j] = plus[j] - minus[j];
        set(part.direction, axis, cell, raised(direction[axis]));
        set(part.moment, axis, cell, moment);
    }
}

}  // namespace

Bernstein<2> cell_coefficients(double c0, double c1, double c2, std::size_t cell) {
    const double from = TimeCells::piece_u(cell, 0.0);
    const double to = TimeCells::piece_u(cell, 1.0);
    return {c0 + from * (c1 + from * c2), c0 + 0.5 * (from + to) * c1 + from * to * c2, c0 + to * (c1 + to * c2)};
}

TimeCells::TimeCells(const MotionPiece& motion) : piece(&motion) {
    for (std::size_t cell = 0; cell < kTimeCells; ++cell) {
        const QuadraticBernstein origin = coefficients_of(motion.origin, cell);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [low, high] = std::ranges::minmax(origin[axis]);
            origin_low[axis][cell] = low;
            origin_high[axis][cell] = high;
        }
        set_part(right, cell, origin, coefficients_of(motion.right, cell));
        set_part(down, cell, origin, coefficients_of(motion.down, cell));
        set_part(view, cell, origin, coefficients_of(motion.view, cell));
    }
}

std::uint32_t TimeCells::overlapping(std::span<const TimeRange> exposures) const {
    std::uint32_t cells = 0;
    for (std::size_t cell = 0; cell < kTimeCells; ++cell) {
        const TimeRange when = {piece->time_at(piece_u(cell, 0.0)), piece->time_at(piece_u(cell, 1.0))};
        for (const TimeRange& exposure : exposures) {
            if (intersection(when, exposure).duration_s() >= 0.0) cells |= 1U << cell;
        }
    }
    return cells;
}

}  // namespace overfly
