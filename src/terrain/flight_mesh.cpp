#include "terrain/flight_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "mesh/connect_triangles.h"
#include "terrain/sample_lattice.h"

namespace overfly {
namespace {

// The largest square, which two of the largest triangles make.
constexpr int kLargest = 256;

// Which samples are corners. The squares of kLargest that cover the raster are halved along a diagonal, those triangles
// through the middle of their hypotenuse, and so on: a sample is the middle of one hypotenuse only, which in a square
// of side s is either a diagonal of the square or one of its sides.
class Refinement {
  public:
    explicit Refinement(const SampleLattice& lattice)
        : lattice_(&lattice),
          squares_across_((lattice.columns() + kLargest - 2) / kLargest),
          squares_down_((lattice.rows() + kLargest - 2) / kLargest),
          width_(squares_across_ * kLargest + 1),
          height_(squares_down_ * kLargest + 1),
          is_split_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {
        for (int side = 2; side <= kLargest; side *= 2) {
            split_sides(side);
            split_diagonals(side);
        }
    }

    [[nodiscard]] int squares() const { return squares_across_ * squares_down_; }
    [[nodiscard]] bool is_split(LatticePoint p) const { return is_inside(p) && is_split_[index(p)] != 0; }

    // Calls leaf(triangle) for every triangle of a square that isn't halved.
    template <class Leaf>
    void each_leaf(int square, const Leaf& leaf) const {
        const LatticePoint corner = {square % squares_across_ * kLargest, square / squares_across_ * kLargest};
        const LatticePoint middle = corner + LatticePoint{kLargest / 2, kLargest / 2};
        const auto [a, b] = diagonal_ends(middle, kLargest / 2);
        const LatticePoint across = {b.row - middle.row, middle.column - b.column};
        descend({a, b, middle + across}, leaf);
        descend({b, a, middle - across}, leaf);
    }

  private:
    [[nodiscard]] bool is_inside(LatticePoint p) const {
        return p.column >= 0 && p.row >= 0 && p.column < width_ && p.row < height_;
    }
    [[nodiscard]] std::size_t index(LatticePoint p) const {
        return static_cast<std::size_t>(p.row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(p.column);
    }

    // The diagonal that halves a square of half side h around `middle` runs to the middle of the square of twice the
    // side, whose coordinates are odd multiples of 2 h.
    [[nodiscard]] static std::array<LatticePoint, 2> diagonal_ends(LatticePoint middle, int h) {
        const auto towards = [&](int v) { return (v + h) / (2 * h) % 2 != 0 ? h : -h; };
        const LatticePoint step = {towards(middle.column), towards(middle.row)};
        return {middle - step, middle + step};
    }

    // Whether the triangles on a hypotenuse have to be halved at its middle v: one of the corners that this makes room
    // for is needed, or one of them doesn't fit.
    [[nodiscard]] bool must_split(LatticePoint v, const std::array<LatticePoint, 4>& next, LatticePoint a,
                                  LatticePoint b) const {
        for (const LatticePoint& p : next) {
            if (is_split(p)) return true;
        }
        const LatticePoint across = {b.row - v.row, v.column - b.column};
        for (const LatticePoint& c : {v + across, v - across}) {
            if (is_inside(c) && !lattice_->fits({a, b, c})) return true;
        }
        return false;
    }

    void split_sides(int side) {
        const int h = side / 2;
        const int q = h / 2;
        parallel_for(static_cast<std::size_t>((height_ - 1) / h) + 1, [&](std::size_t k) {
            const int row = static_cast<int>(k) * h;
            const bool along_row = row % side == 0;
            for (int column = along_row ? h : 0; column < width_; column += side) {
                const LatticePoint v = {column, row};
                const LatticePoint step = along_row ? LatticePoint{h, 0} : LatticePoint{0, h};
                const std::array<LatticePoint, 4> next = {v + LatticePoint{q, q}, v + LatticePoint{-q, q},
                                                          v + LatticePoint{q, -q}, v + LatticePoint{-q, -q}};
                // At the last step there are no more corners between: q is 0 and v itself isn't split yet.
                if (must_split(v, next, v - step, v + step)) is_split_[index(v)] = 1;
            }
        });
    }

    void split_diagonals(int side) {
        const int h = side / 2;
        parallel_for(static_cast<std::size_t>((height_ - 1) / side), [&](std::size_t k) {
            const int row = static_cast<int>(k) * side + h;
            for (int column = h; column < width_; column += side) {
                const LatticePoint v = {column, row};
                const std::array<LatticePoint, 4> next = {v + LatticePoint{h, 0}, v + LatticePoint{-h, 0},
                                                          v + LatticePoint{0, h}, v + LatticePoint{0, -h}};
                const auto [a, b] = diagonal_ends(v, h);
                if (must_split(v, next, a, b)) is_split_[index(v)] = 1;
            }
        });
    }

    template <class Leaf>
    void descend(const LatticeTriangle& t, const Leaf& leaf) const {
        const LatticePoint sum = t.a + t.b;
        const LatticePoint v = {sum.column / 2, sum.row / 2};
        const bool has_middle = sum.column % 2 == 0 && sum.row % 2 == 0;
        if (!has_middle || !is_split(v)) return leaf(t);
        descend({t.c, t.a, v}, leaf);
        descend({t.b, t.c, v}, leaf);
    }

    const SampleLattice* lattice_;
    int squares_across_, squares_down_;
    int width_, height_;
    std::vector<std::uint8_t> is_split_;
};

using Corners = std::array<LatticePoint, 3>;

bool is_half_cell(const LatticeTriangle& t) {
    const LatticePoint leg = t.a - t.c;
    return leg.column * leg.column + leg.row * leg.row == 1;
}

// The triangles of one square whose corners were measured, all run around the same way.
std::vector<Corners> measured_triangles(const SampleLattice& lattice, const Refinement& refinement, int square) {
    std::vector<Corners> out;
    refinement.each_leaf(square, [&](const LatticeTriangle& t) {
        const bool a = lattice.is_valid(t.a), b = lattice.is_valid(t.b), c = lattice.is_valid(t.c);
        const LatticePoint opposite = t.a + t.b - t.c;
        const bool is_upper = t.c.row < opposite.row;
        if (a && b && c) {
            // The other half is a triangle of its own if the refinement came to its corner.
            const bool is_whole = is_half_cell(t) && lattice.is_valid(opposite) && refinement.is_split(opposite);
            if (!is_whole || lattice.has_diagonal(t.a, t.b)) {
                out.push_back({t.a, t.b, t.c});
            } else if (is_upper) {
                out.push_back({t.a, opposite, t.c});
                out.push_back({t.b, t.c, opposite});
            }
            return;
        }
        // One masked end of a cell's diagonal: the cell's other corners make a triangle, which one of its halves adds.
        const bool is_one_end = a != b && c && lattice.is_valid(opposite);
        if (!is_one_end || !is_upper) return;
        if (a) out.push_back({t.a, opposite, t.c});
        if (b) out.push_back({t.b, t.c, opposite});
    });
    return out;
}

// Vertices in the order of the full mesh.
TerrainMesh join(const TerrainMesh& full, const SampleLattice& lattice,
                 const std::vector<std::vector<Corners>>& squares) {
    TerrainMesh mesh;
    for (const auto& triangles : squares) {
        for (const Corners& t : triangles) {
            mesh.triangles.push_back({lattice.vertex(t[0]), lattice.vertex(t[1]), lattice.vertex(t[2])});
        }
    }
    std::vector<VertexId> number(full.positions.size(), kNone);
    for (const auto& t : mesh.triangles) {
        for (const VertexId v : t) number[v] = 0;
    }
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == kNone) continue;
        number[v] = static_cast<VertexId>(mesh.positions.size());
        mesh.positions.push_back(full.positions[v]);
        mesh.elevation_m.push_back(full.elevation_m[v]);
        mesh.samples.push_back(full.samples[v]);
    }
    for (auto& t : mesh.triangles) {
        for (VertexId& v : t) v = number[v];
    }
    return mesh;
}

// Turns all triangles over if they run clockwise seen from above: heights are a function of the place, so every
// triangle with an area tells the same.
void turn_upward(TerrainMesh& mesh, const SceneFrame& frame) {
    for (const auto& t : mesh.triangles) {
        const Point<Scene> p = mesh.positions[t[0]];
        const Vector<Scene> up = frame.local_axes(frame.geodetic(p)).z;
        const double area_m2 = dot(cross(mesh.positions[t[1]] - p, mesh.positions[t[2]] - p), up);
        if (std::abs(area_m2) <= 1e-6) continue;
        if (area_m2 < 0.0) {
            for (auto& turned : mesh.triangles) std::swap(turned[1], turned[2]);
        }
        return;
    }
}

}  // namespace

TerrainMesh triangulate_within(const TerrainMesh& full, const SceneFrame& frame, const AllowedError& allowed_m) {
    const SampleLattice lattice(full, frame, allowed_m);
    check(lattice.columns() >= 2 && lattice.rows() >= 2, "triangulate_within: at least one cell");
    const Refinement refinement(lattice);
    std::vector<std::vector<Corners>> squares(static_cast<std::size_t>(refinement.squares()));
    parallel_for(squares.size(), [&](std::size_t square) {
        squares[square] = measured_triangles(lattice, refinement, static_cast<int>(square));
    });
    TerrainMesh mesh = join(full, lattice, squares);
    turn_upward(mesh, frame);
    connect_triangles(mesh);
    return mesh;
}

}  // namespace overfly
