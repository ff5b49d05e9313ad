#include "shot/shot_body.h"

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "core/error.h"
#include "io/mesh_file.h"
#include "mesh/mesh_plane.h"

namespace overfly {
namespace {

Point<Scene> middle_of(const TriangleMesh& mesh) {
    std::array<double, 3> low{}, high{};
    bool first = true;
    for (const Point<Scene>& p : mesh.positions) {
        const std::array<double, 3> at = {p.x, p.y, p.z};
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = first ? at[k] : std::min(low[k], at[k]);
            high[k] = first ? at[k] : std::max(high[k], at[k]);
        }
        first = false;
    }
    return {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])};
}

FixedPlane mirror_plane(const TriangleMesh& mesh) {
    const MeshPlane plane = plane_of(mesh);
    return {plane.on, plane.normal};
}

}  // namespace

ShotBody::ShotBody(const BodyDocument& document, BodyMesh mesh, BodyPath path)
    : document_(&document),
      mesh_(std::move(mesh)),
      path_(std::move(path)),
      middle_(middle_of(mesh_.mesh)),
      rays_(mesh_.mesh, middle_) {
    for (const Point<Scene>& p : mesh_.mesh.positions) radius_m_ = std::max(radius_m_, distance(p, middle_));
    if (is_mirror()) plane_ = mirror_plane(mesh_.mesh);
}

Reach ShotBody::reach_from(Point<Scene> p) const { return {rays_.distance_m(p), distance(p, middle_) + radius_m_}; }

ShotBodies make_bodies(const ShotDocument& shot, const Stage& stage) {
    const Surroundings surroundings = stage.surroundings();
    std::vector<Problem> problems;
    for (const BodyDocument& body : shot.bodies) {
        const std::vector<Problem> own = check_body_motion(body.name, body.motion, body.places, surroundings);
        problems.insert(problems.end(), own.begin(), own.end());
    }
    if (!problems.empty()) throw UserError(std::move(problems));
    ShotBodies bodies;
    for (const BodyDocument& body : shot.bodies) {
        BodyMesh mesh = read_body_mesh(body.shape, body.motion, surroundings);
        if (body.mirror > 0.0) {
            const MeshPlane plane = plane_of(mesh.mesh);
            if (!plane.is_planar()) {
                throw UserError(
                    body.places.body,
                    fmt::format("body '{}': a mirror has to be plane, but parts of the mesh are {:.3g} m off "
                                "its plane",
                                body.name, plane.farthest_m));
            }
        }
        bodies.push_back(
            std::make_unique<ShotBody>(body, std::move(mesh), BodyPath(body.motion, stage.frame(), surroundings)));
    }
    return bodies;
}

std::vector<std::string> mesh_notes(const ShotBodies& bodies) {
    std::vector<std::string> notes;
    for (const auto& body : bodies) {
        const auto* source = std::get_if<MeshSource>(&body->document().shape);
        const BodyMesh& mesh = body->body_mesh();
        if (source == nullptr || mesh.dropped_degenerate + mesh.skipped_other == 0) continue;
        notes.push_back(
            fmt::format("note: {}: not drawn: faces without area or that cross themselves: {}, points and lines: {}",
                        source->file.string(), mesh.dropped_degenerate, mesh.skipped_other));
    }
    return notes;
}

}  // namespace overfly
