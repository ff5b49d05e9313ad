#include "terrain/triangulate.h"

#include <cmath>
#include <cstddef>

#include "core/error.h"
#include "core/parallel.h"
#include "terrain/cell_triangles.h"

namespace overfly {
namespace {

// Numbers of rows, made into the number of the first item of each row; the total comes last.
std::vector<std::uint32_t> first_of_rows(const std::vector<std::uint32_t>& counts) {
    std::vector<std::uint32_t> first(counts.size() + 1, 0);
    std::uint64_t sum = 0;
    for (std::size_t row = 0; row < counts.size(); ++row) {
        sum += counts[row];
        check(sum < kNone / 4, "triangulate: more triangles than half-edge numbers");
        first[row + 1] = static_cast<std::uint32_t>(sum);
    }
    return first;
}

class GridTriangulation {
  public:
    GridTriangulation(const ElevationModel& model, const SceneFrame& frame, const LocateRow& locate)
        : model_(model),
          frame_(frame),
          locate_(locate),
          columns_(static_cast<std::size_t>(model.columns)),
          rows_(static_cast<std::size_t>(model.rows)) {}

    TerrainMesh run() {
        choose_corners();
        place_vertices();
        choose_diagonals();
        is_mirrored_ = rows_run_north();
        join_triangles();
        return std::move(mesh_);
    }

  private:
    // Which three or four corners of each cell were measured. The diagonals of whole cells wait for positions.
    void choose_corners();
    // One vertex for each sample that a triangle uses.
    void place_vertices();
    void choose_diagonals();
    // Whether the ring of a cell runs clockwise seen from above.
    [[nodiscard]] bool rows_run_north() const;
    void join_triangles();
    void join_row(std::size_t row, const std::vector<std::uint32_t>& first);

    [[nodiscard]] std::size_t sample(std::size_t row, std::size_t column, unsigned corner) const {
        const unsigned c = corner & 3U;
        return (row + (c == 1 || c == 2 ? 1U : 0U)) * columns_ + column + (c >= 2 ? 1U : 0U);
    }
    [[nodiscard]] std::size_t cell(std::size_t row, std::size_t column) const { return row * (columns_ - 1) + column; }
    [[nodiscard]] Point<Scene> position(std::size_t row, std::size_t column, unsigned corner) const {
        return mesh_.positions[vertex_[sample(row, column, corner)]];
    }
    [[nodiscard]] Vector<Scene> normal(std::size_t row, std::size_t column, unsigned start) const {
        const Point<Scene> a = position(row, column, start);
        return cross(position(row, column, start + 1) - a, position(row, column, start + 2) - a);
    }
    // Cosine of the bend along the diagonal between the triangles that start at `start` and at the corner opposite.
    [[nodiscard]] double flatness(std::size_t row, std::size_t column, unsigned start) const {
        const Vector<Scene> a = normal(row, column, start), b = normal(row, column, start + 2);
        return dot(a, b) / std::sqrt(dot(a, a) * dot(b, b));
    }

    const ElevationModel& model_;
    const SceneFrame& frame_;
    const LocateRow& locate_;
    std::size_t columns_, rows_;
    std::vector<CellTriangles> cells_;
    std::vector<VertexId> vertex_;  // of each sample, kNone where no triangle uses it
    bool is_mirrored_ = false;
    TerrainMesh mesh_;
};

void GridTriangulation::choose_corners() {
    cells_.resize((columns_ - 1) * (rows_ - 1));
    parallel_for(rows_ - 1, [&](std::size_t row) {
        for (std::size_t column = 0; column + 1 < columns_; ++column) {
            unsigned masked_count = 0, masked = 0;
            for (unsigned corner = 0; corner < 4; ++corner) {
                if (model_.is_valid[sample(row, column, corner)] != 0) continue;
                ++masked_count;
                masked = corner;
            }
            CellTriangles& triangles = cells_[cell(row, column)];
            if (masked_count == 0) triangles = kDiagonalFromFirst;
            if (masked_count == 1) triangles = triangle_without(masked);
            if (masked_count > 1) triangles = kNothing;
        }
    });
}

void GridTriangulation::place_vertices() {
    const auto is_used = [&](std::size_t row, std::size_t column) {
        // A cell with any triangle leaves out at most one corner, and that one is masked.
        if (model_.is_valid[row * columns_ + column] == 0) return false;
        for (const std::size_t r : {row - 1, row})
            for (const std::size_t c : {column - 1, column})
                if (r < rows_ - 1 && c < columns_ - 1 && cells_[cell(r, c)] != kNothing) return true;
        return false;
    };
    vertex_.assign(model_.size(), kNone);
    std::vector<std::uint32_t> counts(rows_, 0);
    parallel_for(rows_, [&](std::size_t row) {
        for (std::size_t column = 0; column < columns_; ++column)
            if (is_used(row, column)) vertex_[row * columns_ + column] = counts[row]++;
    });
    const std::vector<std::uint32_t> first = first_of_rows(counts);
    mesh_.positions.resize(first.back());
    mesh_.elevation_m.resize(first.back());
    mesh_.samples.resize(first.back());
    parallel_for(rows_, [&](std::size_t row) {
        if (counts[row] == 0) return;
        std::vector<Geodetic> places(columns_);
        locate_(static_cast<int>(row), places);
        for (std::size_t column = 0; column < columns_; ++column) {
            VertexId& v = vertex_[row * columns_ + column];
            if (v == kNone) continue;
            v += first[row];
            mesh_.positions[v] = frame_.scene(places[column]);
            mesh_.elevation_m[v] = model_.height_m[row * columns_ + column];
            mesh_.samples[v] = {static_cast<std::int32_t>(column), static_cast<std::int32_t>(row)};
        }
    });
}

void GridTriangulation::choose_diagonals() {
    parallel_for(rows_ - 1, [&](std::size_t row) {
        for (std::size_t column = 0; column + 1 < columns_; ++column) {
            CellTriangles& triangles = cells_[cell(row, column)];
            if (triangles == kDiagonalFromFirst && flatness(row, column, 1) > flatness(row, column, 0))
                triangles = kDiagonalFromSecond;
        }
    });
}

bool GridTriangulation::rows_run_north() const {
    // Heights are a function of the place, so every triangle with an area tells the same. Those without any are met in
    // rasters that have a row at a pole.
    for (std::size_t row = 0; row + 1 < rows_; ++row)
        for (std::size_t column = 0; column + 1 < columns_; ++column)
            for (unsigned start = 0; start < 4; ++start) {
                if (!has_start(cells_[cell(row, column)], start)) continue;
                const Vector<Scene> up = frame_.local_axes(frame_.geodetic(position(row, column, start))).z;
                const double area_m2 = dot(normal(row, column, start), up);
                if (std::abs(area_m2) > 1e-6) return area_m2 < 0.0;
            }
    return false;
}

void GridTriangulation::join_triangles() {
    std::vector<std::uint32_t> counts(rows_ - 1, 0);
    parallel_for(rows_ - 1, [&](std::size_t row) {
        for (std::size_t column = 0; column + 1 < columns_; ++column)
            counts[row] += triangle_count(cells_[cell(row, column)]);
    });
    const std::vector<std::uint32_t> first = first_of_rows(counts);
    mesh_.triangles.resize(first.back());
    mesh_.twins.resize(first.back());
    parallel_for(rows_ - 1, [&](std::size_t row) { join_row(row, first); });
}

void GridTriangulation::join_row(std::size_t row, const std::vector<std::uint32_t>& first) {
    // The rows above and below are walked in step, so that the numbers of their triangles need no table.
    const bool has_above = row > 0, has_below = row + 2 < rows_;
    TriangleId above_first = has_above ? first[row - 1] : 0, below_first = has_below ? first[row + 1] : 0;
    TriangleId left_first = 0, here_first = first[row];
    CellTriangles left = kNothing;
    for (std::size_t column = 0; column + 1 < columns_; ++column) {
        const CellTriangles here = cells_[cell(row, column)];
        const CellTriangles above = has_above ? cells_[cell(row - 1, column)] : kNothing;
        const CellTriangles below = has_below ? cells_[cell(row + 1, column)] : kNothing;
        const CellTriangles right = column + 2 < columns_ ? cells_[cell(row, column + 1)] : kNothing;
        const TriangleId right_first = here_first + triangle_count(here);
        const std::array<HalfEdgeId, 4> across = {
            half_edge(left, left_first, 2, is_mirrored_), half_edge(below, below_first, 3, is_mirrored_),
            half_edge(right, right_first, 0, is_mirrored_), half_edge(above, above_first, 1, is_mirrored_)};
        TriangleId t = here_first;
        for (unsigned start = 0; start < 4; ++start) {
            if (!has_start(here, start)) continue;
            std::array<VertexId, 3>& corners = mesh_.triangles[t];
            std::array<HalfEdgeId, 3>& twins = mesh_.twins[t];
            for (unsigned k = 0; k < 3; ++k) corners[k] = vertex_[sample(row, column, start + k)];
            const bool is_whole = triangle_count(here) == 2;
            const TriangleId other = t == here_first ? t + 1 : t - 1;
            twins = {across[start], across[(start + 1) & 3U], is_whole ? 4 * other + turned(2, is_mirrored_) : kNone};
            if (is_mirrored_) {
                std::swap(corners[1], corners[2]);
                std::swap(twins[0], twins[2]);
            }
            ++t;
        }
        left = here;
        left_first = here_first;
        here_first = right_first;
        above_first += triangle_count(above);
        below_first += triangle_count(below);
    }
}

}  // namespace

TerrainMesh triangulate(const ElevationModel& model, const SceneFrame& frame, const LocateRow& locate) {
    check(model.columns >= 2 && model.rows >= 2, "triangulate: at least 2x2 samples");
    return GridTriangulation(model, frame, locate).run();
}

}  // namespace overfly
