#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geo/scene_frame.h"
#include "terrain/terrain_mesh.h"

namespace overfly {

// The GUARANTEES of TerrainMesh, checked without the code that makes them: twins are found anew from the corners.
// Returns the first law that is broken, empty where all hold. `may_have_no_area`: rasters with a row at a pole.
inline std::string broken_mesh_law(const TerrainMesh& mesh, const SceneFrame& frame, bool may_have_no_area = false) {
    if (mesh.twins.size() != mesh.triangles.size()) return "as many twins as triangles";
    if (mesh.elevation_m.size() != mesh.positions.size()) return "as many elevations as positions";
    std::map<std::pair<VertexId, VertexId>, HalfEdgeId> sides;
    std::vector<bool> is_used(mesh.positions.size(), false);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        const std::string where = " (triangle " + std::to_string(t) + ")";
        for (unsigned k = 0; k < 3; ++k) {
            if (v[k] >= mesh.positions.size()) return "corners are vertices" + where;
            is_used[v[k]] = true;
            const auto side = std::pair(v[k], v[(k + 1) % 3]);
            if (side.first == side.second) return "no corner is repeated" + where;
            if (!sides.emplace(side, static_cast<HalfEdgeId>(4 * t + k)).second)
                return "two triangles run along a side in opposite directions" + where;
        }
        const Point<Scene> a = mesh.positions[v[0]], b = mesh.positions[v[1]], c = mesh.positions[v[2]];
        const double area_m2 = dot(cross(b - a, c - a), frame.local_axes(frame.geodetic(a)).z);
        if (may_have_no_area ? area_m2 < -1e-3 : area_m2 <= 0.0) return "corners run anticlockwise" + where;
    }
    for (const auto& [side, half_edge] : sides) {
        const auto other = sides.find({side.second, side.first});
        const HalfEdgeId expected = other == sides.end() ? kNone : other->second;
        if (mesh.twins[half_edge / 4][half_edge % 4] != expected)
            return "twins join the triangles of a side (half-edge " + std::to_string(half_edge) + ")";
    }
    for (std::size_t i = 0; i < is_used.size(); ++i)
        if (!is_used[i]) return "every vertex is a corner (vertex " + std::to_string(i) + ")";
    return {};
}

}  // namespace overfly
