#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/colour.h"
#include "film/film_frame.h"
#include "flight/motion.h"
#include "shade/body_light.h"
#include "shade/daylight.h"
#include "shade/lit_ground.h"
#include "shot/ground_triangle.h"
#include "terrain/terrain_mesh.h"
#include "trace/sight.h"

namespace overfly {

struct FactSources;

// What a body in motion looks like, and of what shape it is.
struct ShadedBody {
    const TriangleMesh* mesh = nullptr;
    BodyLook look;
};

// What a line of sight brings to the film at one instant: light of the ground or of a body through the air, what a
// mirror sends on, or where there is nothing the Earth beyond the data and the sky.
class SceneShader {
  public:
    // Keeps references to mesh, light and daylight. The mesh is the one that is looked at, of the same raster as the
    // one that is lit, but may have fewer triangles. Body k is surface k + 1.
    SceneShader(const TerrainMesh& mesh, const LitGround& light, const Daylight& day, bool transparent_sky,
                std::vector<ShadedBody> bodies = {});

    // A line of sight through the film point (x, y) and what it meets.
    struct Sighting {
        double x = 0.0, y = 0.0;
        const SurfaceSegment* seen = nullptr;            // nullptr: the sky
        std::span<const SurfaceSegment> reflected = {};  // of SurfaceSegmentLists

        [[nodiscard]] bool is_of_ground() const {
            return seen != nullptr && seen->triangle != kNone && seen->surface == 0;
        }
    };
    struct Look {
        Sighting sighting;
        double time_s = 0.0;
    };
    // camera: the piece of the rays relative to the scene that the times lie in.
    [[nodiscard]] Radiance radiance(const MotionPiece& camera, const Look& look) const;

    // Light of a surface in parts, which add up to it; but for albedo, the share that it reflects.
    struct Parts {
        Rgb albedo;
        Rgb direct, shadow;  // of the sun if nothing stood before it; and what is missing of that, not above 0
        Rgb sky;             // of all that is around
        Rgb reflection;      // what it mirrors
        [[nodiscard]] Rgb sum() const { return direct + shadow + sky + reflection; }
    };
    // What a look meets. Of the ground its place in the raster tells all the rest.
    struct Described {
        bool is_surface = false;  // ground of the data, or a body
        Vector<Scene> direction;  // of the ray, of unit length
        double depth_m = 0.0, distance_m = 0.0;
        Point<Scene> at, own;  // in the scene, and in the frame of the body
        Vector<Scene> normal;
        Parts parts;
        Rgb behind;  // the air, of which `left` comes through
        Rgb left{1.0F, 1.0F, 1.0F}, haze;
        std::optional<RasterPlace> place;
    };
    [[nodiscard]] Described describe(const MotionPiece& camera, const Look& look) const;

    [[nodiscard]] const LitGround& ground_light() const { return *light_; }
    // What layers are told from; nullptr: there are none.
    [[nodiscard]] const FactSources* facts() const { return facts_; }
    // Must outlive it.
    void set_facts(const FactSources* facts) { facts_ = facts; }

  private:
    friend class ManyLooks;
    friend class LineDeposits;

    // A ray in the scene, and where on it the air begins that has not been counted yet.
    struct Ray {
        Point<Scene> origin;
        Vector<Scene> direction;  // of unit length
        double metres_per_depth = 1.0;
        double from_m = 0.0;
        double from_height_m = 0.0;  // above lowest_m_
    };
    // What a ray meets, and the air that it is still to be seen through, if any.
    struct Behind {
        Radiance radiance;
        std::optional<Daylight::AirPath> air;
        Vector<Scene> direction;
    };
    // Where on a body, and its light.
    struct BodyPoint {
        double depth_m = 0.0;
        Point<Scene> at, own;
        Vector<Scene> normal;
        Parts parts;
    };

    [[nodiscard]] GroundCorner corner(VertexId v) const { return {mesh_->positions[v], mesh_->samples[v]}; }
    [[nodiscard]] Ray ray_of(const MotionPiece& scene, const Sighting& sighting, double u) const;
    [[nodiscard]] Behind beyond(const Ray& ray) const;
    [[nodiscard]] Behind ground(const MotionPiece& scene, const Sighting& sighting, double time_s,
                                const Ray& ray) const;
    [[nodiscard]] GroundTriangle::Hit ground_hit(const MotionPiece& scene, const Sighting& sighting, double time_s,
                                                 const GroundTriangle& triangle) const;
    [[nodiscard]] GroundTriangle ground_triangle(const Sighting& sighting) const;
    [[nodiscard]] BodyPoint body_point(const MotionPiece& scene, const Sighting& sighting, double time_s,
                                       const Ray& ray) const;
    [[nodiscard]] Behind body(const MotionPiece& scene, const Sighting& sighting, double time_s, const Ray& ray) const;
    [[nodiscard]] Behind behind_air(const MotionPiece& camera, const Look& look) const;
    [[nodiscard]] Radiance through_air(const Behind& behind) const;
    [[nodiscard]] Rgb in_mirror(const Sighting& sighting, double time_s, double from_m) const;

    const FactSources* facts_ = nullptr;
    const TerrainMesh* mesh_;
    const LitGround* light_;
    const Daylight* daylight_;
    std::vector<ShadedBody> bodies_;
    bool transparent_sky_;
    double lowest_m_;  // the ground from which heights in the air are counted
};

}  // namespace overfly
