#include "mesh/connect_triangles.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/error.h"

namespace overfly {
namespace {

// A side of a triangle, by its corners in ascending order.
struct Side {
    VertexId low = 0, high = 0;
    HalfEdgeId half_edge = 0;
    bool ascends = false;  // the triangle runs along it from low to high

    [[nodiscard]] bool is_beside(const Side& other) const { return low == other.low && high == other.high; }
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
        for (unsigned k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
            sides.push_back({low, high, 4 * t + k, mesh.triangles[t][k] == low});
        }
    }
    std::ranges::sort(sides, [](const Side& a, const Side& b) {
        if (a.low != b.low) return a.low < b.low;
        return a.high != b.high ? a.high < b.high : a.half_edge < b.half_edge;
    });
    return sides;
}

}  // namespace

void connect_triangles(TriangleMesh& mesh) {
    check(mesh.triangles.size() < kNone / 4, "connect_triangles: more triangles than half-edge numbers");
    mesh.twins.assign(mesh.triangles.size(), {kNone, kNone, kNone});
    const std::vector<Side> sides = sorted_sides(mesh);
    for (std::size_t first = 0; first < sides.size();) {
        std::size_t last = first + 1;
        while (last < sides.size() && sides[last].is_beside(sides[first])) ++last;
        const Side& a = sides[first];
        if (last - first == 2 && a.ascends != sides[first + 1].ascends) {
            const Side& b = sides[first + 1];
            mesh.twins[a.half_edge / 4][a.half_edge % 4] = b.half_edge;
            mesh.twins[b.half_edge / 4][b.half_edge % 4] = a.half_edge;
        }
        first = last;
    }
}

}  // namespace overfly
