#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace overfly {

// A sample of the raster.
struct GridPlace {
    std::int32_t column = 0, row = 0;

    friend constexpr bool operator==(const GridPlace&, const GridPlace&) = default;
};

// The ground: triangles on the ellipsoid, in scene metres, their corners anticlockwise seen from above. A triangle mesh
// with one array more, so that whatever takes a triangle mesh takes terrain as it is; nothing is virtual.
struct TerrainMesh : TriangleMesh {
    std::vector<float> elevation_m;  // of each vertex, as measured: above the terrain's vertical datum
    std::vector<GridPlace> samples;  // of each vertex: which one it is

    [[nodiscard]] std::size_t memory_bytes() const {
        return TriangleMesh::memory_bytes() + elevation_m.size() * (sizeof(float) + sizeof(GridPlace));
    }
    friend bool operator==(const TerrainMesh&, const TerrainMesh&) = default;
};

}  // namespace overfly
