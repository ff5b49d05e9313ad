#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "terrain/terrain_mesh.h"

namespace overfly {

// Vertices in an order in which those that follow each other are near each other: a mesh's own order runs along the
// rows of the raster, where sixty-four neighbours are a line; here they are a square. By bands of kBandRows rows, which
// are runs of vertices in a mesh that follows its raster's rows.
inline constexpr int kBandRows = 8;

// The first vertex of each band, and then the number of vertices.
[[nodiscard]] std::vector<std::size_t> band_starts(std::span<const GridPlace> samples);

// The vertices [first, last), column after column of the raster.
[[nodiscard]] std::vector<VertexId> by_columns(std::span<const GridPlace> samples, std::size_t first, std::size_t last);

}  // namespace overfly
