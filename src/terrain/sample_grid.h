#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "terrain/terrain_mesh.h"

namespace overfly {

// The raster that a mesh was triangulated from, sample by sample: found again from the mesh alone.
struct SampleGrid {
    int columns = 0, rows = 0;           // up to the last sample that is a vertex
    std::vector<VertexId> vertex;        // of each sample, row by row; kNone where no triangle uses it
    std::vector<std::uint8_t> diagonal;  // of the cell whose first sample it is: 1 where it joins the cell's second
                                         // corner (below the first) and its fourth (beside it), else 0

    // REQUIRES: a mesh of triangulate().
    explicit SampleGrid(const TerrainMesh& mesh);

    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
};

}  // namespace overfly
