#pragma once

#include <span>
#include <vector>

#include "core/colour.h"
#include "film/film_frame.h"
#include "flight/motion.h"
#include "shade/body_light.h"
#include "shade/daylight.h"
#include "shade/far_ground.h"
#include "shade/ground_light.h"
#include "terrain/terrain_mesh.h"
#include "trace/sight.h"

namespace overfly {

// What a body in motion looks like, and of what shape it is.
struct ShadedBody {
    const TriangleMesh* mesh = nullptr;
    BodyLook look;
};

// What a line of sight brings to the film at one instant: light of the ground or of a body through the air, what a
// mirror sends on, or where there is nothing the Earth beyond the data and the sky.
class SceneShader {
  public:
    // Keeps references to the mesh and to the daylight. Body k is surface k + 1.
    SceneShader(const TerrainMesh& mesh, const GroundLight& light, const Daylight& day, bool transparent_sky,
                std::vector<ShadedBody> bodies = {});

    // A line of sight through the film point (x, y) and what it meets.
    struct Sighting {
        double x = 0.0, y = 0.0;
        const SurfaceSegment* seen = nullptr;            // nullptr: the sky
        std::span<const SurfaceSegment> reflected = {};  // of SurfaceSegmentLists
    };
    // camera: the piece of the rays relative to the scene that the time lies in.
    [[nodiscard]] Radiance radiance(const MotionPiece& camera, const Sighting& sighting, double time_s) const;

  private:
    // What is interpolated over a triangle of the ground.
    struct Corner {
        Rgb radiance;
        float height_m;  // above lowest_m_
    };
    // A ray in the scene, and where on it the air begins that has not been counted yet.
    struct Ray {
        Point<Scene> origin;
        Vector<Scene> direction;  // of unit length
        double metres_per_depth = 1.0;
        double from_m = 0.0;
        double from_height_m = 0.0;  // above lowest_m_
    };

    [[nodiscard]] Ray ray_of(const MotionPiece& scene, const Sighting& sighting, double u) const;
    [[nodiscard]] Radiance beyond(const Ray& ray) const;
    [[nodiscard]] Radiance ground(const MotionPiece& scene, const Sighting& sighting, double u, const Ray& ray) const;
    [[nodiscard]] Radiance body(const MotionPiece& scene, const Sighting& sighting, double time_s,
                                const Ray& ray) const;
    [[nodiscard]] Rgb in_mirror(const Sighting& sighting, double time_s, double from_m) const;

    const TerrainMesh* mesh_;
    const Daylight* daylight_;
    std::vector<Corner> corners_;   // by vertex
    std::vector<Rgb> without_sun_;  // by vertex
    std::vector<ShadedBody> bodies_;
    FarGround far_;
    bool transparent_sky_;
    double lowest_m_ = 0.0;  // the ground from which heights in the air are counted
};

}  // namespace overfly
