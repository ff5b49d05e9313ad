#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "config/documents.h"
#include "flight/camera_path.h"
#include "flight/motion.h"
#include "geo/geoid.h"
#include "geo/scene_frame.h"
#include "shot/prepare_scene.h"
#include "trace/ray_scene.h"

namespace overfly {

// Terrain and what a flight asks of it, ready for rays. Its parts refer to each other, so it stays where it was made.
// There may be two meshes of it: the full one, with every sample, and one with fewer triangles that a flight can't tell
// from it. Places that count from the ground and the light are the full one's, so that they don't depend on the flight.
class Stage {
  public:
    // around: where float precision matters most, as a rule the flight's middle.
    Stage(PreparedTerrain terrain, const std::optional<Geodetic>& around);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    [[nodiscard]] const PreparedTerrain& terrain() const { return terrain_; }
    [[nodiscard]] const SceneFrame& frame() const { return frame_; }

    // What is looked at: the full mesh until another one takes its place.
    [[nodiscard]] const TerrainMesh& mesh() const { return flight_ ? flight_->mesh : full_mesh(); }
    [[nodiscard]] const RayScene& rays() const { return flight_ ? flight_->rays : full_rays(); }

    [[nodiscard]] const TerrainMesh& full_mesh() const { return terrain_.scene.mesh; }
    [[nodiscard]] const RayScene& full_rays() const;

    // Nobody may refer to mesh() or rays() yet.
    void look_at(TerrainMesh flight_mesh);
    // Frees the full mesh, if it is not the one that is looked at. Nobody may ask for it, or for surroundings, later.
    void drop_full_mesh();

    // Ground by a ray straight down, sea level by the EGM96 geoid. Refers to this stage.
    [[nodiscard]] Surroundings surroundings() const;
    [[nodiscard]] double sea_level_m(Angle lon, Angle lat) const { return geoid_.undulation_m_at(lon, lat); }

  private:
    struct FlightMesh {
        TerrainMesh mesh;
        RayScene rays;
        FlightMesh(TerrainMesh made, Point<Scene> float_centre) : mesh(std::move(made)), rays(mesh, float_centre) {}
    };

    [[nodiscard]] std::optional<double> ground_height_m(Angle lon, Angle lat) const;

    PreparedTerrain terrain_;
    SceneFrame frame_;
    std::optional<RayScene> full_rays_;
    std::optional<FlightMesh> flight_;
    Geoid geoid_;
};

// The middle of a flight's keyframes, heights above ground taken as above the ellipsoid.
[[nodiscard]] std::optional<Geodetic> middle_of(const FlightDocument& flight);

// The path of a flight over the stage. Throws UserError with everything that check_keyframes finds.
[[nodiscard]] CameraPath make_path(const FlightDocument& flight, const Stage& stage);

}  // namespace overfly
