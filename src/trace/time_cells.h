#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/bernstein.h"
#include "flight/motion.h"

namespace overfly {

// A motion piece cut into equal cells of time, small enough that a ray sweeps little in one, and as many as fit the
// widest vector registers: a box or a triangle is tested against all of them at once. What is found in a cell depends
// on that cell alone.
inline constexpr std::size_t kTimeCells = 16;

// One number per cell.
template <class T>
using PerCell = std::array<T, kTimeCells>;

// A vector-valued quartic in the time of each cell: Bernstein coefficients by axis, by order, by cell.
using QuarticVectors = std::array<std::array<PerCell<double>, 5>, 3>;

// The Pluecker coordinates (d, o x d) of a line of sight in every cell.
struct alignas(64) CellLines {
    QuarticVectors direction;
    QuarticVectors moment;
};

// The lines of a piece: that of the film point (x, y) is x * right + y * down + view, part by part.
struct TimeCells {
    explicit TimeCells(const MotionPiece& motion);

    // The cells that overlap any of the exposures, a bit each.
    [[nodiscard]] std::uint32_t overlapping(std::span<const TimeRange> exposures) const;
    // The time within the piece of a time within a cell.
    [[nodiscard]] static double piece_u(std::size_t cell, double u) {
        return (static_cast<double>(cell) + u) * (1.0 / static_cast<double>(kTimeCells));
    }

    const MotionPiece* piece;
    CellLines right, down, view;
    // Bounds of the camera's place in each cell, relative to the piece's reference.
    alignas(64) std::array<PerCell<double>, 3> origin_low, origin_high;
};

// The coefficients in cell `cell` of c0 + c1 u + c2 u^2, u over the piece.
[[nodiscard]] Bernstein<2> cell_coefficients(double c0, double c1, double c2, std::size_t cell);

}  // namespace overfly
