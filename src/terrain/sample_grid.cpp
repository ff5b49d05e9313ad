#include "terrain/sample_grid.h"

#include <algorithm>

namespace overfly {

SampleGrid::SampleGrid(const TerrainMesh& mesh) {
    for (const GridPlace& s : mesh.samples) {
        columns = std::max(columns, s.column + 1);
        rows = std::max(rows, s.row + 1);
    }
    vertex.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), kNone);
    diagonal.assign(vertex.size(), 0);
    for (std::size_t v = 0; v < mesh.samples.size(); ++v) {
        vertex[index(mesh.samples[v].column, mesh.samples[v].row)] = static_cast<VertexId>(v);
    }
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const GridPlace a = mesh.samples[t[k]], b = mesh.samples[t[(k + 1) % 3]];
            const int columns_right = b.column - a.column, rows_down = b.row - a.row;
            if (columns_right * rows_down < 0) {
                diagonal[index(std::min(a.column, b.column), std::min(a.row, b.row))] = 1;
            }
        }
    }
}

}  // namespace overfly
