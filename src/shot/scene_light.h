#pragma once

#include "config/documents.h"
#include "core/progress.h"
#include "shade/ground_facts.h"
#include "shade/ground_light.h"
#include "shot/scene_shader.h"
#include "shot/shot_body.h"
#include "shot/shot_objects.h"
#include "shot/stage.h"

namespace overfly {

// The light of a shot on its terrain, worked out once: on every sample, whatever is looked at.
class SceneLight {
  public:
    // All must outlive it. REQUIRES: the stage still has its full mesh; it is asked for it here only.
    SceneLight(const ShotDocument& shot, const Stage& stage, const Daylight& day, const ShotObjects& objects,
               const Progress& progress);

    [[nodiscard]] SceneShader shader(const ShotBodies& bodies) const;
    // For the layers of the shot.
    [[nodiscard]] const GroundFacts& facts() const { return facts_; }

  private:
    SceneLight(const ShotDocument& shot, const Stage& stage, const Daylight& day, const ShotObjects& objects,
               const GroundLight& light);

    const ShotDocument* shot_;
    const Stage* stage_;
    const Daylight* day_;
    LitGround ground_;
    GroundFacts facts_;
};

}  // namespace overfly
