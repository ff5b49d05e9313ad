#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "config/documents.h"
#include "flight/camera_path.h"
#include "flight/motion.h"
#include "geo/geoid.h"
#include "geo/scene_frame.h"
#include "shot/prepare_scene.h"
#include "trace/ray_scene.h"

namespace overfly {

// Terrain and what a flight asks of it, ready for rays. Its parts refer to each other, so it stays where it was made.
class Stage {
  public:
    // around: where float precision matters most, as a rule the flight's middle.
    Stage(PreparedTerrain terrain, const std::optional<Geodetic>& around);
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    [[nodiscard]] const PreparedTerrain& terrain() const { return terrain_; }
    [[nodiscard]] const TerrainMesh& mesh() const { return terrain_.scene.mesh; }
    [[nodiscard]] const SceneFrame& frame() const { return frame_; }
    [[nodiscard]] const RayScene& rays() const { return rays_; }

    // Ground by a ray straight down, sea level by the EGM96 geoid. Refers to this stage.
    [[nodiscard]] Surroundings surroundings() const;
    [[nodiscard]] double sea_level_m(Angle lon, Angle lat) const { return geoid_.undulation_m_at(lon, lat); }

  private:
    [[nodiscard]] std::optional<double> ground_height_m(Angle lon, Angle lat) const;

    PreparedTerrain terrain_;
    SceneFrame frame_;
    RayScene rays_;
    Geoid geoid_;
};

// The middle of a flight's keyframes, heights above ground taken as above the ellipsoid.
[[nodiscard]] std::optional<Geodetic> middle_of(const FlightDocument& flight);

// The path of a flight over the stage. Throws UserError with everything that check_keyframes finds.
[[nodiscard]] CameraPath make_path(const FlightDocument& flight, const Stage& stage);

}  // namespace overfly
