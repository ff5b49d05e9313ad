#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config/documents.h"
#include "flight/body_path.h"
#include "mesh/body_mesh.h"
#include "shade/body_light.h"
#include "shot/stage.h"
#include "trace/ray_scene.h"

namespace overfly {

// A body of a shot, ready to be looked at. Its parts refer to each other, so it stays where it was made.
class ShotBody {
  public:
    ShotBody(const BodyDocument& document, BodyMesh mesh, BodyPath path);
    ShotBody(const ShotBody&) = delete;
    ShotBody& operator=(const ShotBody&) = delete;

    [[nodiscard]] const BodyDocument& document() const { return *document_; }
    [[nodiscard]] const TriangleMesh& mesh() const { return mesh_.mesh; }
    [[nodiscard]] const BodyMesh& body_mesh() const { return mesh_; }
    [[nodiscard]] const BodyPath& path() const { return path_; }
    [[nodiscard]] const RayScene& rays() const { return rays_; }
    [[nodiscard]] bool is_mirror() const { return document_->mirror > 0.0; }
    // REQUIRES: is_mirror().
    [[nodiscard]] const FixedPlane& plane() const { return plane_; }
    // Of the body, from a point in its own frame.
    [[nodiscard]] Reach reach_from(Point<Scene> p) const;

  private:
    const BodyDocument* document_;
    BodyMesh mesh_;
    BodyPath path_;
    Point<Scene> middle_;
    double radius_m_ = 0.0;  // of a ball around the middle that holds the body
    RayScene rays_;
    FixedPlane plane_;
};

using ShotBodies = std::vector<std::unique_ptr<const ShotBody>>;

// Those of a shot, which must outlive them. Throws UserError with everything that is wrong with their motions, or with
// the first mesh that can't be read or is no mirror though it should be.
[[nodiscard]] ShotBodies make_bodies(const ShotDocument& shot, const Stage& stage);

// What mesh files hold that is not drawn, a line for each such file.
[[nodiscard]] std::vector<std::string> mesh_notes(const ShotBodies& bodies);

}  // namespace overfly
