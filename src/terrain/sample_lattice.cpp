#include "terrain/sample_lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/parallel.h"

namespace overfly {

// The plane of a triangle of samples.
class SampleLattice::Plane {
  public:
    Plane(const SampleLattice& lattice, const LatticeTriangle& t)
        : to_a_(t.a - t.c),
          to_b_(t.b - t.c),
          from_(t.c),
          c_(lattice.position(t.c)),
          // The legs are at right angles and equally long: shares along them are scalar products.
          along_a_((lattice.position(t.a) - c_) / square(to_a_)),
          along_b_((lattice.position(t.b) - c_) / square(to_a_)),
          normal_(cross(along_a_, along_b_)),
          vertical_(dot(normal_, lattice.block_of(t.c).up)) {}

    // Whether p is within the distance of where the plane has the place (twice that is given) of the grid, and along
    // the vertical too: on steep ground a place that the grid's bend has put a little aside is much higher or lower.
    [[nodiscard]] bool is_near(Point<Scene> p, LatticePoint twice, double allowed_m) const {
        const LatticePoint v = twice - (from_ + from_);
        const double share_a = 0.5 * (v.column * to_a_.column + v.row * to_a_.row);
        const double share_b = 0.5 * (v.column * to_b_.column + v.row * to_b_.row);
        const Vector<Scene> off = p - (c_ + (share_a * along_a_ + share_b * along_b_));
        return dot(off, off) <= allowed_m * allowed_m && std::abs(dot(normal_, off)) <= allowed_m * std::abs(vertical_);
    }

  private:
    static double square(LatticePoint v) { return static_cast<double>(v.column * v.column + v.row * v.row); }

    LatticePoint to_a_, to_b_, from_;
    Point<Scene> c_;
    Vector<Scene> along_a_, along_b_, normal_;
    double vertical_;
};

SampleLattice::SampleLattice(const TerrainMesh& full, const SceneFrame& frame, const AllowedError& allowed_m)
    : full_(&full), grid_(full), blocks_across_(static_cast<std::size_t>((grid_.columns + kBlock - 1) / kBlock)) {
    const auto blocks_down = static_cast<std::size_t>((grid_.rows + kBlock - 1) / kBlock);
    blocks_.resize(blocks_down * blocks_across_);
    parallel_for(blocks_down, [&](std::size_t down) {
        for (std::size_t across = 0; across < blocks_across_; ++across) {
            const LatticePoint first = {static_cast<int>(across) * kBlock, static_cast<int>(down) * kBlock};
            blocks_[down * blocks_across_ + across] = make_block(first, frame, allowed_m);
        }
    });
}

SampleLattice::Block SampleLattice::make_block(LatticePoint first, const SceneFrame& frame,
                                               const AllowedError& allowed_m) const {
    const auto each = [&](const auto& visit) {
        for (int row = first.row; row < std::min(first.row + kBlock, rows()); ++row) {
            for (int column = first.column; column < std::min(first.column + kBlock, columns()); ++column) {
                if (is_valid({column, row})) visit(position({column, row}));
            }
        }
    };
    Vector<Scene> sum;
    double count = 0.0;
    each([&](Point<Scene> p) {
        sum = sum + (p - Point<Scene>{});
        count += 1.0;
    });
    if (count == 0.0) return {};
    const Point<Scene> middle = Point<Scene>{} + sum / count;
    double radius_m = 0.0;
    each([&](Point<Scene> p) { radius_m = std::max(radius_m, distance(p, middle)); });
    return {allowed_m(middle, radius_m), frame.local_axes(frame.geodetic(middle)).z};
}

bool SampleLattice::has_diagonal(LatticePoint a, LatticePoint b) const {
    const bool runs_up = (b.column - a.column) * (b.row - a.row) < 0;
    return (grid_.diagonal[grid_.index(std::min(a.column, b.column), std::min(a.row, b.row))] != 0) == runs_up;
}

bool SampleLattice::fits(const LatticeTriangle& t) const {
    const bool is_measured = is_valid(t.a);
    if (is_valid(t.b) != is_measured || is_valid(t.c) != is_measured) return false;
    if (!is_measured) return samples_fit(t, nullptr);
    const Plane plane(*this, t);
    return samples_fit(t, &plane) && side_fits(t.a, t.b, plane) && side_fits(t.b, t.c, plane) &&
           side_fits(t.c, t.a, plane);
}

// plane: nullptr if none of the samples may have been measured.
bool SampleLattice::samples_fit(const LatticeTriangle& t, const Plane* plane) const {
    const LatticePoint to_a = t.a - t.c;
    const LatticePoint to_b = t.b - t.c;
    const int length2 = to_a.column * to_a.column + to_a.row * to_a.row;
    const auto [left, right] = std::minmax({t.a.column, t.b.column, t.c.column});
    const auto [top, bottom] = std::minmax({t.a.row, t.b.row, t.c.row});
    for (int row = top; row <= bottom; ++row) {
        for (int column = left; column <= right; ++column) {
            const LatticePoint p = {column, row};
            const LatticePoint from_c = p - t.c;
            const int share_a = from_c.column * to_a.column + from_c.row * to_a.row;
            const int share_b = from_c.column * to_b.column + from_c.row * to_b.row;
            if (share_a < 0 || share_b < 0 || share_a + share_b > length2) continue;
            if (is_valid(p) != (plane != nullptr)) return false;
            if (plane != nullptr && !plane->is_near(position(p), p + p, block_of(p).allowed_m)) return false;
        }
    }
    return true;
}

// Between samples two surfaces of triangles are farthest apart where sides cross: a side of this one and, in the middle
// of a cell, the full mesh's other diagonal.
bool SampleLattice::side_fits(LatticePoint from, LatticePoint to, const Plane& plane) const {
    const LatticePoint along = to - from;
    if (std::abs(along.column) != std::abs(along.row)) return true;
    const int cells = std::abs(along.column);
    const LatticePoint step = {along.column / cells, along.row / cells};
    for (LatticePoint a = from; !(a == to); a = a + step) {
        const LatticePoint b = a + step;
        if (has_diagonal(a, b)) continue;
        const LatticePoint beside = {b.column, a.row}, below = {a.column, b.row};
        if (!is_valid(beside) || !is_valid(below)) continue;
        const Point<Scene> p = position(beside);
        const Point<Scene> middle = p + 0.5 * (position(below) - p);
        if (!plane.is_near(middle, a + b, block_of(a).allowed_m)) return false;
    }
    return true;
}

}  // namespace overfly
