#pragma once

#include <vector>

#include "mesh/triangle_mesh.h"

namespace overfly {

// The ground: triangles on the ellipsoid, in scene metres, their corners anticlockwise seen from above. A triangle mesh
// with one array more, so that whatever takes a triangle mesh takes terrain as it is; nothing is virtual.
struct TerrainMesh : TriangleMesh {
    std::vector<float> elevation_m;  // of each vertex, as measured: above the terrain's vertical datum

    [[nodiscard]] std::size_t memory_bytes() const {
        return TriangleMesh::memory_bytes() + elevation_m.size() * sizeof(float);
    }
    friend bool operator==(const TerrainMesh&, const TerrainMesh&) = default;
};

}  // namespace overfly
