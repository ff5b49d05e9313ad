#include "shot/scene_shader.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "trace/plane_depth.h"

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

// A vector of the scene in a body's own frame. Both frames look along the same rays, whose three parts stand at right
// angles, also in a mirror.
class CarriedOver {
  public:
    CarriedOver(const MotionPiece& scene, const MotionPiece& body, double time_s)
        : from_(axes_of(scene, scene.u_at(time_s))), to_(axes_of(body, body.u_at(time_s))) {}

    [[nodiscard]] Vector<Scene> operator()(Vector<Scene> v) const {
        Vector<Scene> out;
        for (std::size_t k = 0; k < 3; ++k) out = out + dot(v, from_[k]) * to_[k];
        return out;
    }

  private:
    using Axes = std::array<Vector<Scene>, 3>;
    static Axes axes_of(const MotionPiece& piece, double u) {
        return {normalized(piece.right.at(u)), normalized(piece.down.at(u)), normalized(piece.view.at(u))};
    }
    Axes from_, to_;
};

}  // namespace

SceneShader::SceneShader(const TerrainMesh& mesh, const GroundLight& light, const Daylight& day, bool transparent_sky,
                         std::vector<ShadedBody> bodies)
    : mesh_(&mesh),
      daylight_(&day),
      without_sun_(light.without_sun),
      bodies_(std::move(bodies)),
      far_(mesh, light),
      transparent_sky_(transparent_sky) {
    std::vector<double> heights_m;
    heights_m.reserve(mesh.positions.size());
    for (const Point<Scene>& p : mesh.positions) heights_m.push_back(height_over_ball_m(p));
    if (!heights_m.empty()) lowest_m_ = std::ranges::min(heights_m);
    corners_.reserve(heights_m.size());
    for (std::size_t v = 0; v < heights_m.size(); ++v) {
        corners_.push_back({light.radiance[v], static_cast<float>(heights_m[v] - lowest_m_)});
    }
}

SceneShader::Ray SceneShader::ray_of(const MotionPiece& scene, const Sighting& sighting, double u) const {
    const Vector<Scene> d = scene.direction_at(u, sighting.x, sighting.y);
    const double metres_per_depth = length(d);
    const Point<Scene> origin = scene.origin_at(u);
    return {origin, (1.0 / metres_per_depth) * d, metres_per_depth, 0.0, height_over_ball_m(origin) - lowest_m_};
}

Radiance SceneShader::beyond(const Ray& ray) const {
    if (transparent_sky_ && ray.from_m == 0.0) return {{}, 0.0F, Frame::kNoDepth};
    const Point<Scene> from = ray.origin + ray.from_m * ray.direction;
    if (const auto distance_m = far_.distance_m(from, ray.direction)) {
        const Daylight::AirPath air = {*distance_m, ray.from_height_m, far_.height_m - lowest_m_};
        return {daylight_->through_air(far_.radiance, air, ray.direction), 1.0F, Frame::kNoDepth};
    }
    return {daylight_->background(ray.direction, up_at(from)), 1.0F, Frame::kNoDepth};
}

Radiance SceneShader::ground(const MotionPiece& scene, const Sighting& sighting, double u, const Ray& ray) const {
    const auto& ids = mesh_->triangles[sighting.seen->triangle];
    const Point<Scene> p0 = mesh_->positions[ids[0]];
    const Vector<Scene> d = ray.metres_per_depth * ray.direction;
    // Moller and Trumbore (1997): depth and shares are quotients of determinants with one denominator.
    const Vector<Scene> e1 = mesh_->positions[ids[1]] - p0;
    const Vector<Scene> e2 = mesh_->positions[ids[2]] - p0;
    const Vector<Scene> from = scene.origin.at(u) - (p0 - scene.reference);
    const Vector<Scene> across = cross(d, e2);
    const Vector<Scene> along = cross(from, e1);
    const double inverse = 1.0 / dot(across, e1);
    const double depth_m = inverse * dot(along, e2);
    const Barycentric b = inside(inverse * dot(across, from), inverse * dot(along, d));

    const Corner& c0 = corners_[ids[0]];
    const Corner& c1 = corners_[ids[1]];
    const Corner& c2 = corners_[ids[2]];
    const float b0 = 1.0F - b.b1 - b.b2;
    const Rgb light = sighting.seen->in_shadow
                          ? b0 * without_sun_[ids[0]] + b.b1 * without_sun_[ids[1]] + b.b2 * without_sun_[ids[2]]
                          : b0 * c0.radiance + b.b1 * c1.radiance + b.b2 * c2.radiance;
    const float height_m = b0 * c0.height_m + b.b1 * c1.height_m + b.b2 * c2.height_m;
    const Daylight::AirPath air = {depth_m * ray.metres_per_depth - ray.from_m, ray.from_height_m, height_m};
    return {daylight_->through_air(light, air, ray.direction), 1.0F, static_cast<float>(depth_m)};
}

Radiance SceneShader::body(const MotionPiece& scene, const Sighting& sighting, double time_s, const Ray& ray) const {
    const SurfaceSegment& seen = *sighting.seen;
    const ShadedBody& body = bodies_[seen.surface - 1];
    const PlaneDepth plane(*body.mesh, seen.triangle, *seen.motion, sighting.x, sighting.y);
    const double depth_m = plane.at(seen.motion->u_at(time_s));
    const auto& corner = body.mesh->triangles[seen.triangle];
    const Point<Scene> p0 = body.mesh->positions[corner[0]];
    const Point<Scene> hit = ray.origin + depth_m * ray.metres_per_depth * ray.direction;
    const CarriedOver own(scene, *seen.motion, time_s);
    const Vector<Scene> direction = own(ray.direction);
    Incidence at = {normalized(cross(body.mesh->positions[corner[1]] - p0, body.mesh->positions[corner[2]] - p0)),
                    own(daylight_->to_sun()), own(up_at(hit)), seen.in_shadow};
    if (dot(at.normal, direction) > 0.0) at.normal = -at.normal;
    Rgb light = matt_radiance(body.look.colour, at, *daylight_);
    const double distance_m = depth_m * ray.metres_per_depth;
    if (seen.reflected != kNone) {
        const auto share = static_cast<float>(mirrored_share(body.look.mirror, -dot(at.normal, direction)));
        const Sighting further = {sighting.x, sighting.y, &sighting.reflected[seen.reflected], sighting.reflected};
        light = (1.0F - share) * light + share * in_mirror(further, time_s, distance_m);
    }
    const Daylight::AirPath air = {distance_m - ray.from_m, ray.from_height_m, height_over_ball_m(hit) - lowest_m_};
    return {daylight_->through_air(light, air, ray.direction), 1.0F, static_cast<float>(depth_m)};
}

// What comes along the ray behind a mirror that is from_m away.
Rgb SceneShader::in_mirror(const Sighting& sighting, double time_s, double from_m) const {
    const MotionPiece& scene = sighting.seen->sight->in_scene_at(time_s);
    const double u = scene.u_at(time_s);
    Ray ray = ray_of(scene, sighting, u);
    ray.from_m = from_m;
    ray.from_height_m = height_over_ball_m(ray.origin + from_m * ray.direction) - lowest_m_;
    if (sighting.seen->triangle == kNone) return beyond(ray).colour;
    if (sighting.seen->surface > 0) return body(scene, sighting, time_s, ray).colour;
    return ground(scene, sighting, u, ray).colour;
}

Radiance SceneShader::radiance(const MotionPiece& camera, const Sighting& sighting, double time_s) const {
    const double u = camera.u_at(time_s);
    const Ray ray = ray_of(camera, sighting, u);
    if (sighting.seen == nullptr || sighting.seen->triangle == kNone) return beyond(ray);
    if (sighting.seen->surface > 0) return body(camera, sighting, time_s, ray);
    return ground(camera, sighting, u, ray);
}

}  // namespace overfly
