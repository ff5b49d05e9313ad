#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "trace/shadow_tracer.h"
#include "trace/stretches.h"
#include "trace/time_cells.h"

namespace overfly {

// A stretch or a gap between two that is no longer than this is rounding: what meets at a vertex is cut at the roots of
// different edges; and beside an edge of the seen triangle its neighbour's plane is met at the point itself, so that
// from which side is certain only at some ten roundings of the places over the sine of the angles of sight and sun with
// the ground. On the demo all but one in a thousand such stretches are shorter than this, and no other shorter than
// 1e-7.
inline constexpr double kBlink = 1e-10;  // of the piece

// What a walk follows towards the sun: for one query in each cell, the line from the point P(u) that is seen. With the
// depth n/w at which the line of sight (o, d) meets the plane of the seen triangle, P is the rational P_h / w, where
// P_h = o w + n d is a quartic, and the line towards the sun, along L, has the Pluecker coordinates (L w, P_h x L):
// quartics where the sun stands still (kSunDegree 0), of degree 6 where it turns (2). All relative to the surface that
// stands in the light.
template <std::size_t kSunDegree>
struct ShadowCells {
    static constexpr std::size_t kSide = 4 + kSunDegree;  // degree of the lines

    // REQUIRES: at most kTimeCells queries; `motion` holds the `when` of all, and is constant in to_sun if kSunDegree
    // is 0; it outlives this.
    ShadowCells(const TriangleMesh& mesh, const MotionPiece& motion, std::span<const ShadowQuery> queries);

    const TriangleMesh* mesh;  // that stands in the light
    const MotionPiece* piece;
    std::uint32_t active = 0;  // the cells in use, a bit each
    PolynomialLines<kSide> lines{};
    CellVectors<4> point{};                     // P_h
    std::array<PerCell<double>, 5> weight{};    // w
    alignas(64) CellVectors<kSunDegree> sun{};  // L
    // Bounds of P, relative to the piece's reference.
    alignas(64) std::array<PerCell<double>, 3> point_low{}, point_high{};
    PerCell<TriangleId> seen{};  // if it belongs to this mesh, or kNone
    PerCell<double> blink{};     // kBlink as a share of the cell; 0 if the cell itself is no longer

  private:
    void set_cell(std::size_t cell, const ShadowQuery& query);
    void bound_point(std::size_t cell);
    void bound_by_triangle(std::size_t cell);
};

extern template struct ShadowCells<0>;
extern template struct ShadowCells<2>;

// Whether to_sun turns over the piece by more than 1e-12 rad, which moves the shadow of a thing that is 10 km away by
// ten nanometres.
[[nodiscard]] bool sun_turns(const MotionPiece& motion);

}  // namespace overfly
