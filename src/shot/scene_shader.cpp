#include "shot/scene_shader.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace overfly {
namespace {

// Where on the triangle the line meets its plane: shares of corners 1 and 2, kept inside the triangle against rounding.
struct Barycentric {
    float b1 = 0.0F, b2 = 0.0F;
};

Barycentric inside(double b1, double b2) {
    const double in1 = std::clamp(b1, 0.0, 1.0);
    return {static_cast<float>(in1), static_cast<float>(std::clamp(b2, 0.0, 1.0 - in1))};
}

}  // namespace

SceneShader::SceneShader(const TerrainMesh& mesh, const GroundLight& light, const Daylight& day, bool transparent_sky)
    : mesh_(&mesh), daylight_(&day), far_(mesh, light), transparent_sky_(transparent_sky) {
    std::vector<double> heights_m;
    heights_m.reserve(mesh.positions.size());
    for (const Point<Scene>& p : mesh.positions) heights_m.push_back(height_over_ball_m(p));
    if (!heights_m.empty()) lowest_m_ = std::ranges::min(heights_m);
    corners_.reserve(heights_m.size());
    for (std::size_t v = 0; v < heights_m.size(); ++v) {
        corners_.push_back({light.radiance[v], static_cast<float>(heights_m[v] - lowest_m_)});
    }
}

Radiance SceneShader::beyond(Point<Scene> camera, Vector<Scene> direction) const {
    if (transparent_sky_) return {{}, 0.0F, Frame::kNoDepth};
    if (const auto distance_m = far_.distance_m(camera, direction)) {
        const Daylight::AirPath air = {*distance_m, height_over_ball_m(camera) - lowest_m_, far_.height_m - lowest_m_};
        return {daylight_->through_air(far_.radiance, air, direction), 1.0F, Frame::kNoDepth};
    }
    return {daylight_->background(direction, up_at(camera)), 1.0F, Frame::kNoDepth};
}

Radiance SceneShader::radiance(const MotionPiece& piece, double x, double y, TriangleId triangle, double time_s) const {
    const double u = piece.u_at(time_s);
    const Vector<Scene> o = piece.origin.at(u);
    const Vector<Scene> d = piece.direction_at(u, x, y);
    const double metres_per_depth = length(d);
    const Vector<Scene> direction = (1.0 / metres_per_depth) * d;
    const Point<Scene> camera = piece.reference + o;
    if (triangle == kNone) return beyond(camera, direction);

    const auto& ids = mesh_->triangles[triangle];
    const Point<Scene> p0 = mesh_->positions[ids[0]];
    // Moller and Trumbore (1997): depth and shares are quotients of determinants with one denominator.
    const Vector<Scene> e1 = mesh_->positions[ids[1]] - p0;
    const Vector<Scene> e2 = mesh_->positions[ids[2]] - p0;
    const Vector<Scene> from = o - (p0 - piece.reference);
    const Vector<Scene> across = cross(d, e2);
    const Vector<Scene> along = cross(from, e1);
    const double inverse = 1.0 / dot(across, e1);
    const double depth_m = inverse * dot(along, e2);
    const Barycentric b = inside(inverse * dot(across, from), inverse * dot(along, d));

    const Corner& c0 = corners_[ids[0]];
    const Corner& c1 = corners_[ids[1]];
    const Corner& c2 = corners_[ids[2]];
    const float b0 = 1.0F - b.b1 - b.b2;
    const Rgb ground = b0 * c0.radiance + b.b1 * c1.radiance + b.b2 * c2.radiance;
    const float height_m = b0 * c0.height_m + b.b1 * c1.height_m + b.b2 * c2.height_m;
    const Daylight::AirPath air = {depth_m * metres_per_depth, height_over_ball_m(camera) - lowest_m_, height_m};
    return {daylight_->through_air(ground, air, direction), 1.0F, static_cast<float>(depth_m)};
}

}  // namespace overfly
