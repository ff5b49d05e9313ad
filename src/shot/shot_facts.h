#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "config/documents.h"
#include "flight/camera_path.h"
#include "shade/ground_facts.h"
#include "shade/ground_light.h"
#include "shot/flight_scene.h"
#include "shot/frame_plan.h"
#include "shot/look_facts.h"
#include "shot/shot_body.h"
#include "shot/shot_objects.h"
#include "shot/stage.h"

namespace overfly {

// Longitude and latitude less the scene origin's, in degrees, height above the ellipsoid and above sea level.
[[nodiscard]] Float4 geodetic_fact(const Stage& stage, Point<Scene> p);

// What the full mesh tells, as far as the shot's layers ask for it. light: with its parts, where has_light_parts().
[[nodiscard]] GroundFacts ground_facts(const ShotDocument& shot, const Stage& stage, const GroundLight& light,
                                       const ShotObjects& objects);
[[nodiscard]] bool has_light_parts(LayerSet layers);

// What the layers of a shot are told from. Stays where it was made.
class ShotFacts {
  public:
    // All must outlive it. frames: of the whole shot. REQUIRES: the stage still has its full mesh; it is asked for it
    // here only.
    ShotFacts(const ShotDocument& shot, const Stage& stage, const CameraPath& path,
              std::span<const PlannedFrame> frames, const ShotBodies& bodies, const ShotObjects& objects);
    ShotFacts(const ShotFacts&) = delete;
    ShotFacts& operator=(const ShotFacts&) = delete;

    void set_ground(const GroundFacts& ground) { sources_.ground = &ground; }
    [[nodiscard]] const FactSources& sources() const { return sources_; }

  private:
    Sight sight_;
    FactSources sources_;
};

}  // namespace overfly
