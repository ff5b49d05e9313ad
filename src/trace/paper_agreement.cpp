#include "trace/paper_agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overfly {
namespace {

struct Instant {
    const PaperScene* scene;
    double u;
    Vector<Scene> direction;
};

// From the line of sight to the nearest edge of a polygon, in pixels of the middle of the picture: the angle between
// the line and the plane through the eye and the edge. Infinite where there is no polygon.
double edge_distance_px(const Instant& instant, PaperFrames::Pixel seen) {
    double nearest = std::numeric_limits<double>::infinity();
    if (seen == PaperFrames::kNothing) return nearest;
    const PaperScene& scene = *instant.scene;
    const PaperPolygon& polygon = scene.polygons[seen];
    const auto from_eye = [&](std::uint32_t k) {
        const VertexId corner = scene.corners[polygon.first_corner + k % polygon.corners];
        return scene.positions[corner] + scene.bodies[polygon.body].at(instant.u) - scene.camera.eye;
    };
    for (std::uint32_t k = 0; k < polygon.corners; ++k) {
        const Vector<Scene> normal = cross(from_eye(k), from_eye(k + 1));
        nearest = std::min(nearest, std::abs(dot(normal, instant.direction)) / length(normal));
    }
    return nearest / length(scene.camera.per_column);
}

}  // namespace

PaperAgreement compare(const PaperScene& scene, const PaperFrames& a, const PaperFrames& b, double edge_px) {
    PaperAgreement agreement;
    for (int frame = 0; frame < scene.frames; ++frame) {
        for (int row = 0; row < scene.camera.rows; ++row) {
            for (int column = 0; column < scene.camera.columns; ++column) {
                const PaperFrames::Pixel in_a = a.at(frame, row, column);
                const PaperFrames::Pixel in_b = b.at(frame, row, column);
                ++agreement.pixels;
                if (in_a == in_b) continue;
                ++agreement.differing;
                const Instant instant = {&scene, scene.u_of(frame), scene.camera.direction(row, column)};
                const double distance_px = std::min(edge_distance_px(instant, in_a), edge_distance_px(instant, in_b));
                if (!(distance_px <= edge_px)) ++agreement.unexplained;
            }
        }
    }
    return agreement;
}

}  // namespace overfly
