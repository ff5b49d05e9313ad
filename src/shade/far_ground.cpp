#include "shade/far_ground.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "shade/daylight.h"

namespace overfly {

FarGround::FarGround(const TriangleMesh& mesh, const GroundLight& light) {
    struct Post {
        double height_m;
        VertexId vertex;
    };
    std::vector<Post> border;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            const VertexId v = mesh.triangles[t][k];
            if (mesh.twins[t][k] == kNone) border.push_back({height_over_ball_m(mesh.positions[v]), v});
        }
    }
    if (border.empty()) return;
    const auto middle = border.begin() + static_cast<std::ptrdiff_t>(border.size() / 2);
    const auto order = [](const Post& a, const Post& b) {
        return a.height_m != b.height_m ? a.height_m < b.height_m : a.vertex < b.vertex;
    };
    std::ranges::nth_element(border, middle, order);
    const double share = 1.0 / static_cast<double>(middle + 1 - border.begin());
    for (auto post = border.begin(); post <= middle; ++post) {
        height_m += share * post->height_m;
        radiance += static_cast<float>(share) * light.radiance[post->vertex];
    }
}

std::optional<double> FarGround::distance_m(Point<Scene> from, Vector<Scene> direction) const {
    if (height_over_ball_m(from) <= height_m) return std::nullopt;
    return distance_to_ball_m(from, direction, height_m);
}

}  // namespace overfly
