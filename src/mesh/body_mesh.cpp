#include "mesh/body_mesh.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/error.h"
#include "mesh/connect_triangles.h"

namespace overfly {
namespace {

// For each position the first that is the same.
std::vector<VertexId> first_of_same(std::span<const Point<Scene>> positions) {
    std::vector<VertexId> order(positions.size());
    std::iota(order.begin(), order.end(), VertexId{0});
    std::ranges::sort(order, {},
                      [&](VertexId i) { return std::tuple(positions[i].x, positions[i].y, positions[i].z, i); });
    std::vector<VertexId> result(positions.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool again = k > 0 && positions[order[k]] == positions[order[k - 1]];
        result[order[k]] = again ? result[order[k - 1]] : order[k];
    }
    return result;
}

// Thinner than this share of its length a triangle has no plane: its corners' rounding is 1e-16 of where they are, and
// the body's middle is some lengths away. Thinner than a polygon may be (kOnOneLine), for its triangles are.
constexpr double kNoArea = 1e-12;

bool has_area(Point<Scene> a, Point<Scene> b, Point<Scene> c) {
    const double longest_m = std::max({distance(a, b), distance(b, c), distance(c, a)});
    return length(cross(b - a, c - a)) > kNoArea * longest_m * longest_m;
}

// Drops positions without triangle; the others keep their order.
void keep_used_positions(TriangleMesh& mesh) {
    std::vector<VertexId> new_id(mesh.positions.size(), kNone);
    for (const auto& triangle : mesh.triangles)
        for (const VertexId v : triangle) new_id[v] = 0;
    VertexId count = 0;
    for (std::size_t v = 0; v < new_id.size(); ++v) {
        if (new_id[v] == kNone) continue;
        mesh.positions[count] = mesh.positions[v];
        new_id[v] = count++;
    }
    mesh.positions.resize(count);
    for (auto& triangle : mesh.triangles)
        for (VertexId& v : triangle) v = new_id[v];
}

}  // namespace

BodyMesh body_mesh_of(std::span<const Point<Scene>> positions, std::span<const std::array<VertexId, 3>> triangles) {
    check(positions.size() < kNone && triangles.size() < kNone / 4,
          "body_mesh_of: not more than there are numbers for");
    const std::vector<VertexId> first = first_of_same(positions);
    BodyMesh body;
    for (const auto& [a, b, c] : triangles) {
        if (has_area(positions[a], positions[b], positions[c])) {
            body.mesh.triangles.push_back({first[a], first[b], first[c]});
        } else {
            ++body.dropped_degenerate;
        }
    }
    body.mesh.positions.assign(positions.begin(), positions.end());
    keep_used_positions(body.mesh);
    connect_triangles(body.mesh);
    return body;
}

BodyMesh body_mesh_of(std::span<const Polygon> polygons) {
    std::vector<Point<Scene>> positions;
    std::vector<std::array<VertexId, 3>> triangles;
    for (const Polygon& polygon : polygons) {
        const std::size_t base = positions.size();
        positions.insert(positions.end(), polygon.begin(), polygon.end());
        for (const auto& [a, b, c] : triangulate_polygon(polygon)) {
            triangles.push_back(
                {static_cast<VertexId>(base + a), static_cast<VertexId>(base + b), static_cast<VertexId>(base + c)});
        }
    }
    return body_mesh_of(positions, triangles);
}

}  // namespace overfly
