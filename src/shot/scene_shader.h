#pragma once

#include "film/film_frame.h"
#include "flight/motion.h"
#include "shade/daylight.h"
#include "shade/ground_light.h"
#include "terrain/terrain_mesh.h"

namespace overfly {

// What a line of sight brings to the film at one instant: ground light through the air, or the sky.
class SceneShader {
  public:
    // Keeps references to all three.
    SceneShader(const TerrainMesh& mesh, const GroundLight& light, const Daylight& day, bool transparent_sky);

    // triangle: kNone for the sky.
    [[nodiscard]] Radiance radiance(const MotionPiece& piece, double x, double y, TriangleId triangle,
                                    double time_s) const;

  private:
    const TerrainMesh* mesh_;
    const GroundLight* light_;
    const Daylight* daylight_;
    bool transparent_sky_;
    double lowest_m_ = 0.0;  // the ground from which heights in the air are counted
};

}  // namespace overfly
