#pragma once

#include <cstddef>

#include "flight/motion.h"
#include "shade/ground_triangles.h"

namespace overfly {

// Lines of sight and the triangles of the ground that they meet, many at once, in the layout that vector units like.
struct GroundLooks {
    static constexpr std::size_t kSize = GroundTriangles::kSize;
    template <class T>
    using Lane = GroundTriangles::Lane<T>;

    // Asked: film points, when they look in the piece's u, and the triangles.
    alignas(64) Lane<double> x{}, y{}, u{};
    GroundTriangles triangles;

    // Answered: the place in the raster, the planar depth; the ray's length there, its height where it begins, and the
    // cosine of its angle to the sun.
    alignas(64) Lane<double> met_column{}, met_row{};
    alignas(64) Lane<double> depth_m{}, distance_m{}, from_height_m{}, towards_sun{};
};

// What GroundTriangle says of one goes for the first `count`, to the bit. lowest_m: from where heights are counted, as
// height_over_ball_m counts. to_sun: a unit vector.
void meet_ground(const MotionPiece& scene, Vector<Scene> to_sun, double lowest_m, GroundLooks& looks,
                 std::size_t count);

}  // namespace overfly
