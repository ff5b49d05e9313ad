#include "trace/silhouette.h"

#include <algorithm>
#include <cmath>

#include "core/polynomial_roots.h"

namespace overfly {
namespace {

// A camera this near to a plane may be on either side of it for all that double can tell: coordinates are below 1e6 m,
// and their products are off by a few 2^-53 of that.
constexpr double kCertainHeight_m = 1e-8;

constexpr double kAtEdge = 1e-6;  // of a triangle's size

Vector<Scene> normal_of(const TriangleMesh& mesh, TriangleId triangle) {
    const auto& corner = mesh.triangles[triangle];
    const Point<Scene> v0 = mesh.positions[corner[0]];
    return cross(mesh.positions[corner[1]] - v0, mesh.positions[corner[2]] - v0);
}

bool is_over_triangle(const TriangleMesh& mesh, TriangleId triangle, Point<Scene> p) {
    const auto& corner = mesh.triangles[triangle];
    const Vector<Scene> normal = normal_of(mesh, triangle);
    const double margin = -kAtEdge * dot(normal, normal);
    for (std::size_t k = 0; k < 3; ++k) {
        const Point<Scene> a = mesh.positions[corner[k]];
        const Point<Scene> b = mesh.positions[corner[(k + 1) % 3]];
        if (dot(normal, cross(b - a, p - a)) < margin) return false;
    }
    return true;
}

}  // namespace

Bernstein<2> height_over_plane(const TriangleMesh& mesh, TriangleId triangle, const MotionPiece& piece) {
    const Vector<Scene> normal = normal_of(mesh, triangle);
    const Vector<Scene> from = piece.reference - mesh.positions[mesh.triangles[triangle][0]] + piece.origin.c0;
    const double h0 = dot(normal, from);
    const double h1 = dot(normal, piece.origin.c1);
    const double h2 = dot(normal, piece.origin.c2);
    return {h0, h0 + 0.5 * h1, h0 + (h1 + h2)};
}

Facing facing_over(const TriangleMesh& mesh, TriangleId triangle, const MotionPiece& piece) {
    const Vector<Scene> normal = normal_of(mesh, triangle);
    const Bernstein<2> height = height_over_plane(mesh, triangle, piece);
    const double doubt = kCertainHeight_m * (std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z));
    if (height[0] > doubt && height[1] > doubt && height[2] > doubt) return Facing::Front;
    if (height[0] < -doubt && height[1] < -doubt && height[2] < -doubt) return Facing::Back;
    return Facing::Changes;
}

std::vector<HalfEdgeId> border_edges(const TriangleMesh& mesh) {
    std::vector<HalfEdgeId> edges;
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            if (mesh.twins[t][k] == kNone) edges.push_back(4 * t + k);
        }
    }
    return edges;
}

std::vector<HalfEdgeId> silhouette_edges(const TriangleMesh& mesh, std::span<const HalfEdgeId> borders,
                                         std::span<const Facing> facing) {
    std::vector<HalfEdgeId> edges(borders.begin(), borders.end());
    // Most triangles are seen from the front, so whoever is not looks for the edge.
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
        if (facing[t] == Facing::Front) continue;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const HalfEdgeId twin = mesh.twins[t][k];
            if (twin == kNone) continue;
            const Facing other = facing[twin / 4];
            const bool both_back = facing[t] == Facing::Back && other == Facing::Back;
            if (!both_back && (other == Facing::Front || t < twin / 4)) edges.push_back(4 * t + k);
        }
    }
    return edges;
}

std::vector<double> surface_passages(const TriangleMesh& mesh, std::span<const Facing> facing,
                                     const MotionPiece& piece) {
    std::vector<double> times;
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
        if (facing[t] != Facing::Changes) continue;
        for (const double u : sign_change_roots<2>(height_over_plane(mesh, t, piece))) {
            if (is_over_triangle(mesh, t, piece.origin_at(u))) times.push_back(u);
        }
    }
    std::ranges::sort(times);
    return times;
}

}  // namespace overfly
