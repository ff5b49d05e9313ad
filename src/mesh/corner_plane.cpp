#include "mesh/corner_plane.h"

#include <algorithm>
#include <cmath>

namespace overfly {

CornerPlane corner_plane(std::span<const Point<Scene>> corners) {
    const auto farthest = [&](const auto& measure) { return *std::ranges::max_element(corners, {}, measure); };
    const Point<Scene> first = corners.front();
    const Vector<Scene> along = farthest([&](Point<Scene> p) { return distance(p, first); }) - first;
    CornerPlane plane;
    plane.size_m = length(along);
    if (plane.size_m == 0.0) return plane;
    const Vector<Scene> direction = along / plane.size_m;
    const Vector<Scene> across =
        cross(direction, farthest([&](Point<Scene> p) { return length(cross(direction, p - first)); }) - first);
    plane.width_m = length(across);
    if (plane.width_m > 0.0) plane.normal = across / plane.width_m;
    return plane;
}

std::vector<FlatPoint> flattened(std::span<const Point<Scene>> corners, const Vector<Scene>& normal) {
    const double x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    std::vector<FlatPoint> ring;
    for (const Point<Scene>& p : corners) {
        if (z >= x && z >= y) {
            ring.push_back({p.x, p.y});
        } else {
            ring.push_back(x >= y ? FlatPoint{p.y, p.z} : FlatPoint{p.z, p.x});
        }
    }
    return ring;
}

}  // namespace overfly
