#include "shot/scene_shader.h"

#include <array>
#include <cstddef>
#include <utility>

#include "trace/plane_depth.h"

namespace overfly {
namespace {

// A direction of the scene in a body's own frame. Both frames look along the same rays, also in a mirror. Their three
// parts stand at right angles only where lines of sight don't drift over the picture.
class CarriedOver {
  public:
    CarriedOver(const MotionPiece& scene, const MotionPiece& body, double time_s)
        : from_(duals_of(axes_of(scene, scene.u_at(time_s)))), to_(axes_of(body, body.u_at(time_s))) {}

    [[nodiscard]] Vector<Scene> operator()(Vector<Scene> v) const {
        Vector<Scene> out;
        for (std::size_t k = 0; k < 3; ++k) out = out + dot(v, from_[k]) * to_[k];
        return normalized(out);
    }

  private:
    using Axes = std::array<Vector<Scene>, 3>;
    static Axes axes_of(const MotionPiece& piece, double u) {
        return {piece.right.at(u), piece.down.at(u), piece.view.at(u)};
    }
    // Each tells how much of its axis there is in a vector.
    static Axes duals_of(const Axes& axes) {
        const Vector<Scene> of_right = cross(axes[1], axes[2]), of_down = cross(axes[2], axes[0]);
        const double by = 1.0 / dot(axes[0], of_right);
        return {by * of_right, by * of_down, by * cross(axes[0], axes[1])};
    }
    Axes from_, to_;
};

}  // namespace

SceneShader::SceneShader(const TerrainMesh& mesh, const LitGround& light, const Daylight& day, bool transparent_sky,
                         std::vector<ShadedBody> bodies)
    : mesh_(&mesh),
      light_(&light),
      daylight_(&day),
      bodies_(std::move(bodies)),
      transparent_sky_(transparent_sky),
      lowest_m_(light.lowest_m()) {}

SceneShader::Ray SceneShader::ray_of(const MotionPiece& scene, const Sighting& sighting, double u) const {
    const Vector<Scene> d = scene.direction_at(u, sighting.x, sighting.y);
    const double metres_per_depth = length(d);
    const Point<Scene> origin = scene.origin_at(u);
    return {origin, (1.0 / metres_per_depth) * d, metres_per_depth, 0.0, height_over_ball_m(origin) - lowest_m_};
}

SceneShader::Behind SceneShader::beyond(const Ray& ray) const {
    if (transparent_sky_ && ray.from_m == 0.0) return {{{}, 0.0F, Frame::kNoDepth}, {}, ray.direction};
    const Point<Scene> from = ray.origin + ray.from_m * ray.direction;
    if (const auto distance_m = light_->far().distance_m(from, ray.direction)) {
        const Daylight::AirPath air = {*distance_m, ray.from_height_m, light_->far().height_m - lowest_m_};
        return {{light_->far().radiance, 1.0F, Frame::kNoDepth}, air, ray.direction};
    }
    return {{daylight_->background(ray.direction, up_at(from)), 1.0F, Frame::kNoDepth}, {}, ray.direction};
}

GroundTriangle SceneShader::ground_triangle(const Sighting& sighting) const {
    const auto& ids = mesh_->triangles[sighting.seen->triangle];
    return {corner(ids[0]), corner(ids[1]), corner(ids[2])};
}

// By the piece's own direction, as meet_ground has it: the ray's, of unit length, differs from it by a rounding.
GroundTriangle::Hit SceneShader::ground_hit(const MotionPiece& scene, const Sighting& sighting, double time_s,
                                            const GroundTriangle& triangle) const {
    const double u = scene.u_at(time_s);
    return triangle.hit(scene, u, scene.direction_at(u, sighting.x, sighting.y));
}

SceneShader::Behind SceneShader::ground(const MotionPiece& scene, const Sighting& sighting, double time_s,
                                        const Ray& ray) const {
    const GroundTriangle triangle = ground_triangle(sighting);
    const GroundTriangle::Hit hit = ground_hit(scene, sighting, time_s, triangle);
    const LitGround::Place place = light_->at(triangle.place(hit), sighting.seen->in_shadow);
    const Daylight::AirPath air = {hit.depth_m * ray.metres_per_depth - ray.from_m, ray.from_height_m, place.height_m};
    return {{place.radiance, 1.0F, static_cast<float>(hit.depth_m)}, air, ray.direction};
}

SceneShader::BodyPoint SceneShader::body_point(const MotionPiece& scene, const Sighting& sighting, double time_s,
                                               const Ray& ray) const {
    const SurfaceSegment& seen = *sighting.seen;
    const ShadedBody& body = bodies_[seen.surface - 1];
    const PlaneDepth plane(*body.mesh, seen.triangle, *seen.motion, sighting.x, sighting.y);
    BodyPoint out;
    const double u = seen.motion->u_at(time_s);
    out.depth_m = plane.at(u);
    const double distance_m = out.depth_m * ray.metres_per_depth;
    out.at = ray.origin + distance_m * ray.direction;
    out.own = seen.motion->origin_at(u) + out.depth_m * seen.motion->direction_at(u, sighting.x, sighting.y);
    const auto& corner = body.mesh->triangles[seen.triangle];
    const Point<Scene> p0 = body.mesh->positions[corner[0]];
    const CarriedOver own(scene, *seen.motion, time_s);
    const Vector<Scene> direction = own(ray.direction);
    Incidence at = {normalized(cross(body.mesh->positions[corner[1]] - p0, body.mesh->positions[corner[2]] - p0)),
                    own(daylight_->to_sun()), own(up_at(out.at))};
    if (dot(at.normal, direction) > 0.0) at.normal = -at.normal;
    out.normal = CarriedOver(*seen.motion, scene, time_s)(at.normal);
    MattLight light = matt_light(body.look.colour, at, *daylight_);
    out.parts.albedo = body.look.colour;
    if (seen.reflected != kNone) {
        const auto share = static_cast<float>(mirrored_share(body.look.mirror, -dot(at.normal, direction)));
        const Sighting further = {sighting.x, sighting.y, &sighting.reflected[seen.reflected], sighting.reflected};
        light = {(1.0F - share) * light.sun, (1.0F - share) * light.around};
        out.parts.reflection = share * in_mirror(further, time_s, distance_m);
    }
    out.parts.direct = light.sun;
    if (seen.in_shadow) out.parts.shadow = -1.0F * light.sun;
    out.parts.sky = light.around;
    return out;
}

SceneShader::Behind SceneShader::body(const MotionPiece& scene, const Sighting& sighting, double time_s,
                                      const Ray& ray) const {
    const BodyPoint hit = body_point(scene, sighting, time_s, ray);
    const Daylight::AirPath air = {hit.depth_m * ray.metres_per_depth - ray.from_m, ray.from_height_m,
                                   height_over_ball_m(hit.at) - lowest_m_};
    return {{hit.parts.sum(), 1.0F, static_cast<float>(hit.depth_m)}, air, ray.direction};
}

// What comes along the ray behind a mirror that is from_m away.
Rgb SceneShader::in_mirror(const Sighting& sighting, double time_s, double from_m) const {
    const MotionPiece& scene = sighting.seen->sight->in_scene_at(time_s);
    const double u = scene.u_at(time_s);
    Ray ray = ray_of(scene, sighting, u);
    ray.from_m = from_m;
    ray.from_height_m = height_over_ball_m(ray.origin + from_m * ray.direction) - lowest_m_;
    if (sighting.seen->triangle == kNone) return through_air(beyond(ray)).colour;
    if (sighting.seen->surface > 0) return through_air(body(scene, sighting, time_s, ray)).colour;
    return through_air(ground(scene, sighting, time_s, ray)).colour;
}

SceneShader::Behind SceneShader::behind_air(const MotionPiece& camera, const Look& look) const {
    const Sighting& sighting = look.sighting;
    const Ray ray = ray_of(camera, sighting, camera.u_at(look.time_s));
    if (sighting.seen == nullptr || sighting.seen->triangle == kNone) return beyond(ray);
    if (sighting.seen->surface > 0) return body(camera, sighting, look.time_s, ray);
    return ground(camera, sighting, look.time_s, ray);
}

Radiance SceneShader::through_air(const Behind& behind) const {
    Radiance out = behind.radiance;
    if (behind.air) out.colour = daylight_->through_air(out.colour, *behind.air, behind.direction);
    return out;
}

SceneShader::Described SceneShader::describe(const MotionPiece& camera, const Look& look) const {
    const Sighting& sighting = look.sighting;
    const Ray ray = ray_of(camera, sighting, camera.u_at(look.time_s));
    const Behind behind = behind_air(camera, look);
    Described out;
    out.direction = behind.direction;
    out.behind = behind.radiance.colour;
    if (behind.air) {
        const Daylight::AirShare air = daylight_->share_of_air(*behind.air, behind.direction);
        out.left = air.left;
        out.haze = air.haze;
        out.distance_m = behind.air->distance_m;
    }
    out.is_surface = sighting.seen != nullptr && sighting.seen->triangle != kNone;
    if (!out.is_surface) return out;
    if (sighting.is_of_ground()) {
        const GroundTriangle triangle = ground_triangle(sighting);
        const GroundTriangle::Hit hit = ground_hit(camera, sighting, look.time_s, triangle);
        out.depth_m = hit.depth_m;
        out.place = triangle.place(hit);
        return out;
    }
    const BodyPoint hit = body_point(camera, sighting, look.time_s, ray);
    out.depth_m = hit.depth_m;
    out.at = hit.at;
    out.own = hit.own;
    out.normal = hit.normal;
    out.parts = hit.parts;
    return out;
}

Radiance SceneShader::radiance(const MotionPiece& camera, const Look& look) const {
    return through_air(behind_air(camera, look));
}

}  // namespace overfly
