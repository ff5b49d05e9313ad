#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/bernstein.h"
#include "flight/motion.h"

namespace overfly {

// The cells that a walk tests a box or a triangle against at once, as many as fill the widest vector registers. Each is
// one exposure (its part in one motion piece) of one sample; exposures first, then neighbouring samples. What is found
// in a cell depends on that cell alone.
// Two cells an exposure were tried: 835 ns instead of 710 per pixel and frame on the demo, as fewer samples share a
// walk, but 1,594 instead of 2,207 on a flight over the same ground at three times the speed.
inline constexpr std::size_t kTimeCells = 16;

// One number per cell.
template <class T>
using PerCell = std::array<T, kTimeCells>;

// A vector-valued polynomial of degree N in the time of each cell: Bernstein coefficients by axis, by order, by cell.
template <std::size_t N>
using CellVectors = std::array<std::array<PerCell<double>, N + 1>, 3>;
using QuarticVectors = CellVectors<4>;

// The Pluecker coordinates (d, o x d) of a line in every cell, or a common multiple of them.
template <std::size_t N>
struct alignas(64) PolynomialLines {
    CellVectors<N> direction;
    CellVectors<N> moment;
};
using CellLines = PolynomialLines<4>;

// The lines of a piece: that of the film point (x, y) is x * right + y * down + view, part by part.
struct TimeCells {
    // REQUIRES: one to kTimeCells exposures, each within the piece, in time order; an instant is one without duration.
    TimeCells(const MotionPiece& motion, std::span<const TimeRange> exposures);

    // Samples that share the cells: each has all exposures, one sample's cells after the other's.
    [[nodiscard]] std::size_t samples_together() const { return kTimeCells / exposures.size(); }
    [[nodiscard]] const TimeRange& exposure_of(std::size_t cell) const { return exposures[cell % exposures.size()]; }

    // The time within the piece of a time within a cell, and that on the flight's axis: at the ends of an exposure
    // exactly the exposure's own.
    [[nodiscard]] double piece_u(std::size_t cell, double u) const { return from[cell] + u * (to[cell] - from[cell]); }
    [[nodiscard]] double time_s(std::size_t cell, double u) const;
    // The coefficients in a cell of c0 + c1 u + c2 u^2, u over the piece.
    [[nodiscard]] Bernstein<2> coefficients(double c0, double c1, double c2, std::size_t cell) const {
        return quadratic_over(c0, c1, c2, from[cell], to[cell]);
    }

    const MotionPiece* piece;
    std::vector<TimeRange> exposures;
    PerCell<double> from{}, to{};  // of each cell, in the piece's u
    CellLines right{}, down{}, view{};
    // Bounds of the camera's place in each cell, relative to the piece's reference.
    alignas(64) std::array<PerCell<double>, 3> origin_low{}, origin_high{};
};

}  // namespace overfly
