#include "trace/kinetic_look.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace overfly {
namespace {

constexpr int kMostSurfaces = 8;  // folds and borders beside the line that float takes for hits
constexpr int kMostSteps = 16;    // around a vertex

// Just behind what was decided against; a float can tell.
constexpr double kBehind = 1.0 + 1e-6;

// Across the side that the line passes furthest on the wrong side of, until it is inside; nothing where the surface
// ends before that.
std::optional<TriangleId> walk(const TriangleMesh& mesh, const Line& line, TriangleId triangle) {
    TriangleId before = kNone;
    for (int step = 0; step < kMostSteps; ++step) {
        const EdgeValues values = edge_values(mesh, triangle, line);
        if (values.inside()) return triangle;
        const double facing = values.at[0] + values.at[1] + values.at[2];
        std::size_t worst = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            if (values.at[k] * facing < values.at[worst] * facing) worst = k;
        }
        const HalfEdgeId twin = mesh.twins[triangle][worst];
        // Off a border, or to and fro across a fold.
        if (twin == kNone || twin / 4 == before) return std::nullopt;
        before = triangle;
        triangle = twin / 4;
    }
    return std::nullopt;
}

// The triangles that share a corner with one, itself included, as far as they are connected at the corner.
class Neighbourhood {
  public:
    Neighbourhood(const TriangleMesh& mesh, TriangleId middle) : mesh_(&mesh) {
        for (const VertexId corner : mesh.triangles[middle]) {
            add(middle);
            std::size_t next = members_.size();
            add_neighbours(middle, corner);
            for (; next < members_.size(); ++next) add_neighbours(members_[next], corner);
        }
    }

    [[nodiscard]] std::span<const TriangleId> members() const { return members_; }

  private:
    void add(TriangleId t) {
        if (std::ranges::find(members_, t) == members_.end()) members_.push_back(t);
    }
    // Across the two sides that meet in the corner.
    void add_neighbours(TriangleId t, VertexId corner) {
        for (std::size_t k = 0; k < 3; ++k) {
            const bool meets = mesh_->triangles[t][k] == corner || mesh_->triangles[t][(k + 1) % 3] == corner;
            const HalfEdgeId twin = mesh_->twins[t][k];
            if (meets && twin != kNone) add(twin / 4);
        }
    }

    const TriangleMesh* mesh_;
    std::vector<TriangleId> members_;
};

}  // namespace

TriangleId look_around(const TriangleMesh& mesh, const Line& line, TriangleId middle, double least) {
    TriangleId nearest = kNone;
    double nearest_depth = std::numeric_limits<double>::infinity();
    const Neighbourhood around(mesh, middle);
    for (const TriangleId t : around.members()) {
        if (!edge_values(mesh, t, line).inside()) continue;
        const double depth = depth_on(mesh, t, line);
        if (!(depth > least && depth < nearest_depth)) continue;
        nearest = t;
        nearest_depth = depth;
    }
    return nearest;
}

TriangleId look(const RayScene& scene, const Line& line, double least) {
    double from = least;
    for (int surface = 0; surface < kMostSurfaces; ++surface) {
        const auto hit = scene.first_hit(line.reference + line.origin, line.direction, from);
        if (!hit) return kNone;
        auto found = walk(scene.mesh(), line, hit->triangle);
        if (!found || depth_on(scene.mesh(), *found, line) < from)
            found = look_around(scene.mesh(), line, hit->triangle, least);
        if (*found != kNone) return *found;
        from = std::max(from, hit->distance) * kBehind;
    }
    return kNone;
}

}  // namespace overfly
