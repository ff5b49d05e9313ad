#include "trace/time_cells.h"

#include <algorithm>

namespace overfly {
namespace {

using QuadraticBernstein = std::array<Bernstein<2>, 3>;  // by axis

QuadraticBernstein coefficients_of(const TimeCells& cells, const QuadraticVector& q, std::size_t cell) {
    return {cells.coefficients(q.c0.x, q.c1.x, q.c2.x, cell), cells.coefficients(q.c0.y, q.c1.y, q.c2.y, cell),
            cells.coefficients(q.c0.z, q.c1.z, q.c2.z, cell)};
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

TimeCells::TimeCells(const MotionPiece& motion, std::span<const TimeRange> within)
    : piece(&motion), exposures(within.begin(), within.end()) {
    for (std::size_t cell = 0; cell < samples_together() * exposures.size(); ++cell) {
        from[cell] = motion.u_at(exposure_of(cell).begin_s);
        to[cell] = motion.u_at(exposure_of(cell).end_s);
    }
    for (std::size_t cell = 0; cell < kTimeCells; ++cell) {
        const QuadraticBernstein origin = coefficients_of(*this, motion.origin, cell);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [low, high] = std::ranges::minmax(origin[axis]);
            origin_low[axis][cell] = low;
            origin_high[axis][cell] = high;
        }
        set_part(right, cell, origin, coefficients_of(*this, motion.right, cell));
        set_part(down, cell, origin, coefficients_of(*this, motion.down, cell));
        set_part(view, cell, origin, coefficients_of(*this, motion.view, cell));
    }
}

double TimeCells::time_s(std::size_t cell, double u) const {
    const TimeRange& exposure = exposure_of(cell);
    return u == 1.0 ? exposure.end_s : exposure.begin_s + u * exposure.duration_s();
}

}  // namespace overfly
