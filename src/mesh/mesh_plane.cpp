#include "mesh/mesh_plane.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "mesh/polygon.h"

namespace overfly {
namespace {

// Twice the area of each triangle, as a vector across it.
std::vector<Vector<Scene>> areas(const TriangleMesh& mesh) {
    std::vector<Vector<Scene>> result;
    for (const auto& [a, b, c] : mesh.triangles)
        result.push_back(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
    return result;
}

Vector<Scene> mean_normal(const TriangleMesh& mesh) {
    const std::vector<Vector<Scene>> all = areas(mesh);
    const Vector<Scene> largest = *std::ranges::max_element(all, {}, [](const auto& a) { return length(a); });
    Vector<Scene> sum;
    for (const Vector<Scene>& area : all) sum = dot(area, largest) < 0.0 ? sum - area : sum + area;
    return normalized(sum);
}

}  // namespace

bool MeshPlane::is_planar() const { return farthest_m <= kPlanar * size_m; }

MeshPlane plane_of(const TriangleMesh& mesh) {
    check(!mesh.triangles.empty(), "plane_of: a mesh has a triangle");
    MeshPlane plane;
    plane.normal = mean_normal(mesh);
    // Relative to one of the positions, so that a body far from its origin loses no digits.
    const Point<Scene> near = mesh.positions.front();
    Vector<Scene> sum, low, high;
    for (const Point<Scene>& p : mesh.positions) {
        const Vector<Scene> v = p - near;
        sum = sum + v;
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    plane.on = near + sum / static_cast<double>(mesh.positions.size());
    plane.size_m = length(high - low);
    for (const Point<Scene>& p : mesh.positions)
        plane.farthest_m = std::max(plane.farthest_m, std::abs(dot(plane.normal, p - plane.on)));
    return plane;
}

}  // namespace overfly
