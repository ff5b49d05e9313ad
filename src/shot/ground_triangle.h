#pragma once

#include <algorithm>

#include "flight/motion.h"
#include "shade/lit_ground.h"
#include "terrain/terrain_mesh.h"

namespace overfly {

// A vertex of the ground.
struct GroundCorner {
    Point<Scene> position;
    GridPlace sample;
};

// A triangle of the ground as a line of sight meets it, in the scene and in the raster.
class GroundTriangle {
  public:
    GroundTriangle(const GroundCorner& c0, const GroundCorner& c1, const GroundCorner& c2)
        : p0_(c0.position),
          e1_(c1.position - c0.position),
          e2_(c2.position - c0.position),
          normal_(cross(e1_, e2_)),
          s0_(c0.sample),
          s1_{c1.sample.column - c0.sample.column, c1.sample.row - c0.sample.row},
          s2_{c2.sample.column - c0.sample.column, c2.sample.row - c0.sample.row} {}

    // Shares of corners 1 and 2, kept inside the triangle against rounding.
    struct Hit {
        double depth_m = 0.0;
        double b1 = 0.0, b2 = 0.0;
    };
    // direction: of the piece at u. Of a triangle that is seen from its edge, any corner.
    [[nodiscard]] Hit hit(const MotionPiece& scene, double u, Vector<Scene> direction) const {
        // Moller and Trumbore (1997): quotients of determinants with one denominator; the normal is in two of the four.
        const Vector<Scene> from = scene.origin.at(u) - (p0_ - scene.reference);
        const Vector<Scene> turned = cross(from, direction);
        const double inverse = -1.0 / dot(direction, normal_);
        return inside(inverse * dot(from, normal_), inverse * dot(e2_, turned), -inverse * dot(e1_, turned));
    }
    [[nodiscard]] RasterPlace place(const Hit& hit) const {
        return {s0_.column + hit.b1 * s1_.column + hit.b2 * s2_.column, s0_.row + hit.b1 * s1_.row + hit.b2 * s2_.row};
    }

  private:
    // What is no number becomes 0.
    [[nodiscard]] static Hit inside(double depth_m, double b1, double b2) {
        const double in1 = b1 > 0.0 ? std::min(b1, 1.0) : 0.0;
        return {depth_m, in1, b2 > 0.0 ? std::min(b2, 1.0 - in1) : 0.0};
    }

    Point<Scene> p0_;
    Vector<Scene> e1_, e2_, normal_;
    GridPlace s0_, s1_, s2_;  // the latter from the first
};

}  // namespace overfly
