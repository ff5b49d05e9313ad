#include "trace/kinetic_edge.h"

#include <algorithm>
#include <limits>

namespace overfly {

EdgeSide::EdgeSide(const Bernstein<4>& side) : side_(side) {
    const auto first = std::ranges::find_if(side, [](double c) { return c != 0.0; });
    if (first == side.end()) return;
    first_sign_ = *first > 0.0 ? 1.0 : -1.0;
    roots_ = sign_change_roots<4>(side);
}

double EdgeSide::sign_after(double u) const {
    double sign = first_sign_;
    for (const double root : roots_) {
        if (root <= u) sign = -sign;
    }
    return sign;
}

double EdgeSide::next_root(double u) const {
    for (const double root : roots_) {
        if (root > u) return root;
    }
    return std::numeric_limits<double>::infinity();
}

EdgePoint edge_point(const TriangleMesh& mesh, HalfEdgeId half_edge, const Line& line) {
    const auto& corner = mesh.triangles[half_edge / 4];
    const Point<Scene> a = mesh.positions[corner[half_edge % 4]];
    const Vector<Scene> edge = mesh.positions[corner[(half_edge % 4 + 1) % 3]] - a;
    const Vector<Scene> to_a = a - line.reference - line.origin;
    const Vector<Scene> normal = cross(line.direction, edge);
    const double scale = 1.0 / dot(normal, normal);
    return {dot(cross(to_a, edge), normal) * scale, dot(cross(to_a, line.direction), normal) * scale};
}

}  // namespace overfly
