#include "terrain/sample_lattice.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace overfly {

SampleLattice::SampleLattice(const ElevationModel& model, const SceneFrame& frame, const LocateRow& locate,
                             const AllowedError& allowed_m)
    : columns_(model.columns),
      rows_(model.rows),
      blocks_(static_cast<std::size_t>((model.columns + kBlock - 1) / kBlock)),
      is_valid_(model.is_valid),
      positions_(model.size()) {
    parallel_for(static_cast<std::size_t>(rows_), [&](std::size_t row) {
        const std::size_t first = row * static_cast<std::size_t>(columns_);
        std::vector<Geodetic> places(static_cast<std::size_t>(columns_));
        locate(static_cast<int>(row), places);
        for (std::size_t column = 0; column < places.size(); ++column) {
            if (is_valid_[first + column] != 0) positions_[first + column] = frame.scene(places[column]);
        }
    });
    allow(allowed_m);
}

void SampleLattice::allow(const AllowedError& allowed_m) {
    const auto block_rows = static_cast<std::size_t>((rows_ + kBlock - 1) / kBlock);
    allowed_m_.assign(block_rows * blocks_, 0.0);
    parallel_for(block_rows, [&](std::size_t block_row) {
        for (std::size_t block = 0; block < blocks_; ++block) {
            const int top = static_cast<int>(block_row) * kBlock;
            const int left = static_cast<int>(block) * kBlock;
            Vector<Scene> sum;
            double count = 0.0;
            const auto each = [&](const auto& visit) {
                for (int row = top; row < std::min(top + kBlock, rows_); ++row) {
                    for (int column = left; column < std::min(left + kBlock, columns_); ++column) {
                        if (is_valid({column, row})) visit(position({column, row}));
                    }
                }
            };
            each([&](Point<Scene> p) {
                sum = sum + (p - Point<Scene>{});
                count += 1.0;
            });
            if (count == 0.0) continue;
            const Point<Scene> middle = Point<Scene>{} + sum / count;
            double radius_m = 0.0;
            each([&](Point<Scene> p) { radius_m = std::max(radius_m, distance(p, middle)); });
            allowed_m_[block_row * blocks_ + block] = allowed_m(middle, radius_m);
        }
    });
}

bool SampleLattice::fits(const LatticeTriangle& t) const {
    const bool is_measured = is_valid(t.a);
    if (is_valid(t.b) != is_measured || is_valid(t.c) != is_measured) return false;
    const LatticePoint to_a = t.a - t.c;
    const LatticePoint to_b = t.b - t.c;
    // The legs are at right angles and equally long: shares along them are scalar products.
    const int length2 = to_a.column * to_a.column + to_a.row * to_a.row;
    const Point<Scene> c = is_measured ? position(t.c) : Point<Scene>{};
    const Vector<Scene> along_a = is_measured ? (position(t.a) - c) / length2 : Vector<Scene>{};
    const Vector<Scene> along_b = is_measured ? (position(t.b) - c) / length2 : Vector<Scene>{};
    const auto [left, right] = std::minmax({t.a.column, t.b.column, t.c.column});
    const auto [top, bottom] = std::minmax({t.a.row, t.b.row, t.c.row});
    for (int row = top; row <= bottom; ++row) {
        for (int column = left; column <= right; ++column) {
            const LatticePoint from_c = LatticePoint{column, row} - t.c;
            const int share_a = from_c.column * to_a.column + from_c.row * to_a.row;
            const int share_b = from_c.column * to_b.column + from_c.row * to_b.row;
            if (share_a < 0 || share_b < 0 || share_a + share_b > length2) continue;
            if (is_valid({column, row}) != is_measured) return false;
            if (!is_measured) continue;
            const Point<Scene> on =
                c + (static_cast<double>(share_a) * along_a + static_cast<double>(share_b) * along_b);
            const Vector<Scene> off = position({column, row}) - on;
            const double allowed_m = allowed_m_at({column, row});
            if (dot(off, off) > allowed_m * allowed_m) return false;
        }
    }
    return true;
}

}  // namespace overfly
