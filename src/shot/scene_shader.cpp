#include "shot/scene_shader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace overfly {
namespace {

// Where on the triangle the line meets its plane: shares of corners 1 and 2, kept inside the triangle against rounding.
struct Barycentric {
    float b1 = 0.0F, b2 = 0.0F;
};

Barycentric barycentric(const std::array<Vector<Scene>, 3>& corner, Vector<Scene> p) {
    const Vector<Scene> e1 = corner[1] - corner[0];
    const Vector<Scene> e2 = corner[2] - corner[0];
    const Vector<Scene> n = cross(e1, e2);
    const Vector<Scene> q = p - corner[0];
    const double scale = 1.0 / dot(n, n);
    const double b1 = std::clamp(dot(cross(q, e2), n) * scale, 0.0, 1.0);
    const double b2 = std::clamp(dot(cross(e1, q), n) * scale, 0.0, 1.0 - b1);
    return {static_cast<float>(b1), static_cast<float>(b2)};
}

}  // namespace

SceneShader::SceneShader(const TerrainMesh& mesh, const GroundLight& light, const Daylight& day, bool transparent_sky)
    : mesh_(&mesh), light_(&light), daylight_(&day), transparent_sky_(transparent_sky) {
    double lowest_m = std::numeric_limits<double>::infinity();
    for (const Point<Scene>& p : mesh.positions) lowest_m = std::min(lowest_m, height_over_ball_m(p));
    if (std::isfinite(lowest_m)) lowest_m_ = lowest_m;
}

Radiance SceneShader::radiance(const MotionPiece& piece, double x, double y, TriangleId triangle, double time_s) const {
    const double u = piece.u_at(time_s);
    const Vector<Scene> o = piece.origin.at(u);
    const Vector<Scene> d = piece.direction_at(u, x, y);
    const double metres_per_depth = length(d);
    const Vector<Scene> direction = d / metres_per_depth;
    const Point<Scene> camera = piece.reference + o;
    if (triangle == kNone) {
        if (transparent_sky_) return {{}, 0.0F, Frame::kNoDepth};
        return {daylight_->background(direction, up_at(camera)), 1.0F, Frame::kNoDepth};
    }
    const auto& ids = mesh_->triangles[triangle];
    const std::array<Vector<Scene>, 3> corner = {mesh_->positions[ids[0]] - piece.reference,
                                                 mesh_->positions[ids[1]] - piece.reference,
                                                 mesh_->positions[ids[2]] - piece.reference};
    const Vector<Scene> normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double depth_m = dot(normal, corner[0] - o) / dot(normal, d);
    const Vector<Scene> hit = o + depth_m * d;
    const Barycentric b = barycentric(corner, hit);
    const Rgb ground = (1.0F - b.b1 - b.b2) * light_->radiance[ids[0]] + b.b1 * light_->radiance[ids[1]] +
                       b.b2 * light_->radiance[ids[2]];
    const Daylight::AirPath air = {depth_m * metres_per_depth, height_over_ball_m(camera) - lowest_m_,
                                   height_over_ball_m(piece.reference + hit) - lowest_m_};
    return {daylight_->through_air(ground, air, direction), 1.0F, static_cast<float>(depth_m)};
}

}  // namespace overfly
