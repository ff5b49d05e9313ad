#include "shot/look_facts.h"

#include "flight/film_drift.h"

namespace overfly {
namespace {

// So far away a point stands for a direction, whichever way the camera goes meanwhile.
constexpr double kFar_m = 1e10;

Rgb rgb(Float4 v) { return {v[0], v[1], v[2]}; }
Rgb less(Rgb a, Rgb b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }

}  // namespace

// A look in parts: where, and light behind the air.
struct LookFacts::Lit {
    bool is_surface = false;
    Point<Scene> at;
    double depth_m = 0.0, distance_m = 0.0;
    Float4 normal{}, geodetic{};
    SceneShader::Parts parts;
    Rgb background;              // behind the air
    Rgb left{1.0F, 1.0F, 1.0F};  // the share of all this that comes through it
    Rgb haze;
};

Told LookFacts::of_ground(const GroundLook& look, const FrameSteps& steps) const {
    const double u = camera_->u_at(look.time_s);
    const Vector<Scene> direction = camera_->direction_at(u, look.x, look.y);
    const LitGround& light = shader_->ground_light();
    const LitGround::Corners corners = light.corners(look.place);
    const GroundFacts& facts = *sources_->ground;
    const auto fact = [&](GroundFacts::Kind kind) { return facts.has(kind) ? facts.at(kind, corners) : Float4{}; };
    Lit lit;
    lit.is_surface = true;
    lit.at = camera_->origin_at(u) + look.depth_m * direction;
    lit.depth_m = look.depth_m;
    lit.distance_m = look.depth_m * length(direction);
    lit.normal = fact(GroundFacts::Kind::Normal);
    lit.geodetic = fact(GroundFacts::Kind::Geodetic);
    lit.parts.albedo = rgb(fact(GroundFacts::Kind::Albedo));
    lit.parts.direct = rgb(fact(GroundFacts::Kind::Sunlight));
    lit.parts.sky = light.at(look.place, true).radiance;
    lit.parts.shadow = less(less(look.behind, lit.parts.sky), lit.parts.direct);
    lit.left = look.left;
    lit.haze = less(look.seen, look.left * look.behind);
    return told(lit, {0, lit.at, look.time_s}, steps);
}

Told LookFacts::of(const SceneShader::Look& look, const FrameSteps& steps) const {
    const SceneShader::Described seen = shader_->describe(*camera_, look);
    if (seen.place) {
        return of_ground({look.sighting.x, look.sighting.y, look.time_s, seen.depth_m, *seen.place, seen.behind,
                          seen.left, seen.behind * seen.left + seen.haze},
                         steps);
    }
    Lit lit;
    lit.is_surface = seen.is_surface;
    lit.left = seen.left;
    lit.haze = seen.haze;
    if (!seen.is_surface) {
        lit.background = seen.behind;
        const Point<Scene> far = camera_->origin_at(camera_->u_at(look.time_s)) + kFar_m * seen.direction;
        return told(lit, {0, far, look.time_s}, steps);
    }
    lit.at = seen.at;
    lit.depth_m = seen.depth_m;
    lit.distance_m = seen.distance_m;
    lit.normal = four(seen.normal);
    if (sources_->kinds.quantities.has(Quantity::Geodetic)) lit.geodetic = sources_->geodetic(seen.at);
    lit.parts = seen.parts;
    return told(lit, {look.sighting.seen->surface, seen.own, look.time_s}, steps);
}

Told LookFacts::told(const Lit& lit, const Mark& mark, const FrameSteps& steps) const {
    Told out{};
    const Quantities& wanted = sources_->kinds.quantities;
    for (std::size_t slot = 0; slot < wanted.count(); ++slot) {
        Float4& value = out[slot];
        switch (wanted.at(slot)) {
            case Quantity::Surface:
                if (lit.is_surface)
                    value = Float4{1.0F, static_cast<float>(lit.depth_m), static_cast<float>(lit.distance_m), 0.0F};
                break;
            case Quantity::Effort:  // counted by whoever adds
                break;
            case Quantity::Position:
                if (lit.is_surface) value = four(lit.at - Point<Scene>{});
                break;
            case Quantity::Normal:
                value = lit.normal;
                break;
            case Quantity::Geodetic:
                value = lit.geodetic;
                break;
            case Quantity::Motion:
                value = motion(mark, steps);
                break;
            case Quantity::Albedo:
                value = four(lit.parts.albedo);
                break;
            case Quantity::Direct:
                value = four(lit.left * lit.parts.direct);
                break;
            case Quantity::Shadow:
                value = four(lit.left * lit.parts.shadow);
                break;
            case Quantity::Sky:
                value = four(lit.left * lit.parts.sky);
                break;
            case Quantity::Haze:
                value = four(lit.haze);
                break;
            case Quantity::Background:
                value = four(lit.left * lit.background);
                break;
            case Quantity::Reflection:
                value = four(lit.left * lit.parts.reflection);
                break;
        }
    }
    return out;
}

// By the camera's own motion: lines may drift, and the world may have been made to stand still.
Float4 LookFacts::motion(const Mark& mark, const FrameSteps& steps) const {
    const Motion& motion = sources_->sight->motions[mark.surface];
    const double time_s = steps.instant_s.value_or(mark.time_s);
    const auto seen_at = [&](double t) {
        const MotionPiece& piece = motion.piece_at(t);
        return film_point(piece, piece.u_at(t), mark.own);
    };
    const FilmPoint now = seen_at(time_s);
    const auto moved = [&](const FilmPoint& then) {
        if (now.depth_m <= 0.0 || then.depth_m <= 0.0) return std::array{0.0F, 0.0F};
        return std::array{static_cast<float>(sources_->px_per_film * (then.x - now.x)),
                          static_cast<float>(sources_->px_per_film * (then.y - now.y))};
    };
    const auto forward = moved(seen_at(time_s + steps.next_s)), backward = moved(seen_at(time_s - steps.previous_s));
    return Float4{forward[0], forward[1], backward[0], backward[1]};
}

ObjectNumber LookFacts::object_of(const SceneShader::Look& look) const {
    const SurfaceSegment* const seen = look.sighting.seen;
    if (seen == nullptr || seen->triangle == kNone) return 0;
    if (seen->surface == 0 && sources_->ground->has_objects())
        return object_on_ground(*shader_->describe(*camera_, look).place);
    return sources_->surfaces[seen->surface];
}

ObjectNumber LookFacts::object_on_ground(RasterPlace place) const {
    const ObjectNumber object = sources_->ground->object_at(place);
    return object != 0 ? object : sources_->surfaces.front();
}

}  // namespace overfly
