#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "terrain/terrain_mesh.h"

namespace overfly {

// Triangles of the ground by corner, many at once, in the layout that vector units like.
struct GroundTriangles {
    static constexpr std::size_t kSize = 64;
    template <class T>
    using Lane = std::array<T, kSize>;

    alignas(64) std::array<std::array<Lane<double>, 3>, 3> corner{};  // [corner][axis], in the scene
    alignas(64) std::array<Lane<std::int32_t>, 3> column{}, row{};    // of the corners in the raster

    void set(std::size_t i, const TerrainMesh& mesh, TriangleId triangle) {
        for (std::size_t c = 0; c < 3; ++c) {
            const VertexId v = mesh.triangles[triangle][c];
            const Point<Scene> p = mesh.positions[v];
            corner[c][0][i] = p.x;
            corner[c][1][i] = p.y;
            corner[c][2][i] = p.z;
            column[c][i] = mesh.samples[v].column;
            row[c][i] = mesh.samples[v].row;
        }
    }
};

}  // namespace overfly
