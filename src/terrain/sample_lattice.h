#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "terrain/flight_mesh.h"

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

// The samples of a model where they are, and the error that is allowed there.
class SampleLattice {
  public:
    SampleLattice(const ElevationModel& model, const SceneFrame& frame, const LocateRow& locate,
                  const AllowedError& allowed_m);

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int rows() const { return rows_; }
    [[nodiscard]] bool is_valid(LatticePoint p) const {
        return p.column >= 0 && p.row >= 0 && p.column < columns_ && p.row < rows_ && is_valid_[index(p)] != 0;
    }
    [[nodiscard]] std::size_t index(LatticePoint p) const {
        return static_cast<std::size_t>(p.row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(p.column);
    }
    // REQUIRES: is_valid(p).
    [[nodiscard]] Point<Scene> position(LatticePoint p) const { return positions_[index(p)]; }

    // Whether the triangle may stand for all of its samples: none is farther from it than is allowed, or none was
    // measured. A triangle that has both kinds may not.
    [[nodiscard]] bool fits(const LatticeTriangle& t) const;

  private:
    static constexpr int kBlock = 16;

    void allow(const AllowedError& allowed_m);
    [[nodiscard]] double allowed_m_at(LatticePoint p) const {
        return allowed_m_[static_cast<std::size_t>(p.row / kBlock) * blocks_ +
                          static_cast<std::size_t>(p.column / kBlock)];
    }

    int columns_, rows_;
    std::size_t blocks_;  // in a row of blocks
    const std::vector<std::uint8_t>& is_valid_;
    std::vector<Point<Scene>> positions_;
    std::vector<double> allowed_m_;  // by block
};

}  // namespace overfly
