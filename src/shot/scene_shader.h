#pragma once

#include <vector>

#include "core/colour.h"
#include "film/film_frame.h"
#include "flight/motion.h"
#include "shade/daylight.h"
#include "shade/far_ground.h"
#include "shade/ground_light.h"
#include "terrain/terrain_mesh.h"

namespace overfly {

// What a line of sight brings to the film at one instant: ground light through the air, or where there is no ground the
// Earth beyond the data and the sky.
class SceneShader {
  public:
    // Keeps references to the mesh and to the daylight.
    SceneShader(const TerrainMesh& mesh, const GroundLight& light, const Daylight& day, bool transparent_sky);

    // triangle: kNone for the sky.
    [[nodiscard]] Radiance radiance(const MotionPiece& piece, double x, double y, TriangleId triangle,
                                    double time_s) const;

  private:
    // What is interpolated over a triangle.
    struct Corner {
        Rgb radiance;
        float height_m;  // above lowest_m_
    };

    [[nodiscard]] Radiance beyond(Point<Scene> camera, Vector<Scene> direction) const;

    const TerrainMesh* mesh_;
    const Daylight* daylight_;
    std::vector<Corner> corners_;  // by vertex
    FarGround far_;
    bool transparent_sky_;
    double lowest_m_ = 0.0;  // the ground from which heights in the air are counted
};

}  // namespace overfly
