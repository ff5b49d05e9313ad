#pragma once

#include <cstddef>
#include <vector>

#include "terrain/flight_mesh.h"
#include "terrain/sample_grid.h"

namespace overfly {

// A place in the grid of samples, or beyond its right and lower borders.
struct LatticePoint {
    int column = 0, row = 0;

    friend constexpr LatticePoint operator+(LatticePoint a, LatticePoint b) {
        return {a.column + b.column, a.row + b.row};
    }
    friend constexpr LatticePoint operator-(LatticePoint a, LatticePoint b) {
        return {a.column - b.column, a.row - b.row};
    }
    friend constexpr bool operator==(LatticePoint, LatticePoint) = default;
};

// A right triangle of samples: its hypotenuse from a to b, the right angle at c.
struct LatticeTriangle {
    LatticePoint a, b, c;
};

// The samples of a full mesh where they are, and the error that is allowed there.
class SampleLattice {
  public:
    // The mesh must outlive it.
    SampleLattice(const TerrainMesh& full, const SceneFrame& frame, const AllowedError& allowed_m);

    [[nodiscard]] int columns() const { return grid_.columns; }
    [[nodiscard]] int rows() const { return grid_.rows; }
    [[nodiscard]] bool is_valid(LatticePoint p) const {
        return p.column >= 0 && p.row >= 0 && p.column < grid_.columns && p.row < grid_.rows && vertex(p) != kNone;
    }
    // In the full mesh. REQUIRES: p is in the grid.
    [[nodiscard]] VertexId vertex(LatticePoint p) const { return grid_.vertex[grid_.index(p.column, p.row)]; }
    // Whether the full mesh has a side along the diagonal of a cell from a to b. REQUIRES: all of its corners are
    // valid.
    [[nodiscard]] bool has_diagonal(LatticePoint a, LatticePoint b) const;

    // Whether the triangle may stand for all of the full mesh that it lies over: nothing of that is farther from it
    // than is allowed, or nothing was measured. A triangle that has both kinds may not.
    [[nodiscard]] bool fits(const LatticeTriangle& t) const;

  private:
    static constexpr int kBlock = 16;

    struct Block {
        double allowed_m = 0.0;
        Vector<Scene> up;
    };
    class Plane;

    [[nodiscard]] Point<Scene> position(LatticePoint p) const { return full_->positions[vertex(p)]; }
    [[nodiscard]] Block make_block(LatticePoint first, const SceneFrame& frame, const AllowedError& allowed_m) const;
    [[nodiscard]] const Block& block_of(LatticePoint p) const {
        return blocks_[static_cast<std::size_t>(p.row / kBlock) * blocks_across_ +
                       static_cast<std::size_t>(p.column / kBlock)];
    }
    [[nodiscard]] bool samples_fit(const LatticeTriangle& t, const Plane* plane) const;
    [[nodiscard]] bool side_fits(LatticePoint from, LatticePoint to, const Plane& plane) const;

    const TerrainMesh* full_;
    SampleGrid grid_;
    std::size_t blocks_across_;
    std::vector<Block> blocks_;
};

}  // namespace overfly
