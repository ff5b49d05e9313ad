#pragma once

#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

#include "flight/motion.h"
#include "mesh/connect_triangles.h"
#include "support/terrains.h"
#include "trace/line.h"
#include "trace/sight.h"

namespace overfly::testing {

// Where the samples of all tests are.
inline constexpr FilmBounds kPicture = {-1.0, 1.0, -1.0, 1.0};

// An upright box around the origin of its own frame.
inline TriangleMesh box(double half_x_m, double half_y_m, double half_z_m) {
    TriangleMesh mesh;
    for (const double z : {-half_z_m, half_z_m}) {
        for (const auto& [x, y] :
             {std::pair{-1.0, -1.0}, std::pair{1.0, -1.0}, std::pair{1.0, 1.0}, std::pair{-1.0, 1.0}}) {
            mesh.positions.push_back({x * half_x_m, y * half_y_m, z});
        }
    }
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
    for (VertexId k = 0; k < 4; ++k) {
        const VertexId next = (k + 1) % 4;
        mesh.triangles.push_back({k, next, next + 4});
        mesh.triangles.push_back({k, next + 4, k + 4});
    }
    connect_triangles(mesh);
    return mesh;
}

// A level square around the origin of its own frame, facing up.
inline TriangleMesh square(double half_side_m) {
    TriangleMesh mesh;
    const double h = half_side_m;
    mesh.positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    connect_triangles(mesh);
    return mesh;
}

// Turned about an axis by an angle.
inline Rotation<Scene, Body> turned(Vector<Scene> axis, double angle_rad) {
    const Vector<Scene> k = normalized(axis);
    const auto turn = [&](Vector<Scene> v) {
        return std::cos(angle_rad) * v + std::sin(angle_rad) * cross(k, v) +
               (1.0 - std::cos(angle_rad)) * dot(k, v) * k;
    };
    return {turn({1, 0, 0}), turn({0, 1, 0}), turn({0, 0, 1})};
}

// One of several things in a scene, with a tracer of its own.
struct Thing {
    TriangleMesh mesh;
    PoseAt pose_at{};  // empty: stands still in the scene
    bool is_mirror = false;
    FixedPlane plane{};
};

// Rough ground, and bodies that move over, through and in front of it, looked at by a camera that flies and turns.
class MovingScene {
  public:
    // With a sun, everything throws shadows.
    explicit MovingScene(std::vector<Thing> things, bool discrete = false, Vector<Scene> to_sun = {})
        : things_(std::move(things)), to_sun_(to_sun) {
        tracers_.reserve(things_.size());
        for (const Thing& thing : things_) {
            scenes_.push_back(std::make_unique<RayScene>(thing.mesh, Point<Scene>{}));
            if (discrete) {
                tracers_.emplace_back(DiscreteTracer(*scenes_.back()));
            } else {
                tracers_.emplace_back(IntervalTracer(thing.mesh));
            }
        }
        for (std::size_t s = 0; s < things_.size(); ++s) {
            if (discrete) {
                blockers_.emplace_back(DiscreteShadowTracer(*scenes_[s]));
            } else {
                blockers_.emplace_back(
                    ShadowTracer(things_[s].mesh, std::get<IntervalTracer>(tracers_[s]).hierarchy()));
            }
        }
        for (std::size_t s = 0; s < things_.size(); ++s) {
            const SunBlocker* blocker = to_sun == Vector<Scene>{} ? nullptr : &blockers_[s];
            surfaces_.push_back({&things_[s].mesh, &tracers_[s], nullptr, blocker, blocker != nullptr,
                                 things_[s].is_mirror, things_[s].plane});
        }
    }

    [[nodiscard]] const std::vector<Thing>& things() const { return things_; }
    [[nodiscard]] std::span<const Surface> surfaces() const { return surfaces_; }

    // Seen by rays of the scene, between those times.
    [[nodiscard]] Sight sight(const std::function<RayFrame(double)>& rays_at, const std::vector<double>& cuts_s,
                              int mirrors, std::uint32_t in_mirror = kNone) const {
        Sight out;
        out.in_mirror = in_mirror;
        for (std::size_t s = 0; s < things_.size(); ++s) {
            const PoseAt& pose_at = things_[s].pose_at;
            const View view = {[&](double t) { return pose_at ? seen_from(pose_at(t), rays_at(t)) : rays_at(t); },
                               [](double, Point<Scene>) { return Reach{20.0}; },
                               [&](double t) { return pose_at ? seen_from(pose_at(t), to_sun_) : to_sun_; }};
            out.motions.push_back(fit_motion(view, cuts_s, {}));
        }
        for (std::uint32_t m = 0; m < things_.size(); ++m) {
            if (mirrors == 0 || m == in_mirror || !things_[m].is_mirror) continue;
            const auto behind = [&, m](double t) {
                const FixedPlane& plane = things_[m].plane;
                return mirrored(rays_at(t), things_[m].pose_at ? in_scene(things_[m].pose_at(t), plane) : plane);
            };
            std::vector<double> cuts = {cuts_s.front()};
            for (const MotionPiece& piece : out.motions[m].pieces) cuts.push_back(piece.when.end_s);
            out.mirrored.push_back(sight(behind, cuts, mirrors - 1, m));
        }
        return out;
    }

  private:
    std::vector<Thing> things_;
    Vector<Scene> to_sun_;
    std::vector<std::unique_ptr<RayScene>> scenes_;
    std::vector<Tracer> tracers_;
    std::deque<SunBlocker> blockers_;
    std::vector<Surface> surfaces_;
};

// The obvious answer of what one looks at: every triangle of everything at one instant, in double.
struct Seen {
    std::uint32_t surface = 0;
    TriangleId triangle = kNone;

    friend bool operator==(const Seen&, const Seen&) = default;
};

struct SeenAt {
    Seen what;
    double depth_m = std::numeric_limits<double>::infinity();
};

inline SeenAt brute_force(const MovingScene& scene, const Sight& sight, const ImageSample& sample, double time_s,
                          double least_m = 0.0) {
    SeenAt nearest;
    for (std::uint32_t s = 0; s < scene.things().size(); ++s) {
        if (s == sight.in_mirror) continue;
        const MotionPiece& piece = sight.motions[s].piece_at(time_s);
        const double u = piece.u_at(time_s);
        const Line line = {piece.reference, piece.origin.at(u), piece.direction_at(u, sample.x, sample.y)};
        const TriangleMesh& mesh = scene.things()[s].mesh;
        for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
            if (!edge_values(mesh, t, line).inside()) continue;
            const double depth_m = depth_on(mesh, t, line);
            if (depth_m > least_m && depth_m < nearest.depth_m) nearest = {{s, t}, depth_m};
        }
    }
    return nearest;
}

// What is seen in turn, mirror after mirror, the sky last where nothing is hit.
inline std::vector<Seen> brute_force_chain(const MovingScene& scene, const Sight& sight, const ImageSample& sample,
                                           double time_s) {
    std::vector<Seen> chain;
    const Sight* looker = &sight;
    double least_m = 0.0;
    while (looker != nullptr) {
        const SeenAt seen = brute_force(scene, *looker, sample, time_s, least_m);
        chain.push_back(seen.what);
        const Sight* next = nullptr;
        for (const Sight& mirrored : looker->mirrored) {
            if (seen.what.triangle != kNone && mirrored.in_mirror == seen.what.surface) next = &mirrored;
        }
        looker = next;
        least_m = seen.depth_m;
    }
    return chain;
}

// Whether anything stands between what is seen and the sun.
inline bool brute_force_shadow(const MovingScene& scene, const Sight& sight, const ImageSample& sample,
                               const SeenAt& seen, double time_s) {
    for (std::uint32_t s = 0; s < scene.things().size(); ++s) {
        const MotionPiece& piece = sight.motions[s].piece_at(time_s);
        const double u = piece.u_at(time_s);
        const Line line = {piece.reference,
                           piece.origin.at(u) + seen.depth_m * piece.direction_at(u, sample.x, sample.y),
                           piece.to_sun.at(u)};
        const TriangleMesh& mesh = scene.things()[s].mesh;
        for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
            if (seen.what == Seen{s, t}) continue;
            if (edge_values(mesh, t, line).inside() && depth_on(mesh, t, line) > 0.0) return true;
        }
    }
    return false;
}

}  // namespace overfly::testing
