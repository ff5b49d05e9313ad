#pragma once

#include <array>
#include <cstddef>

#include "flight/motion.h"

namespace overfly {

// Lines of sight and the triangles of the ground that they meet, many at once, in the layout that vector units like.
struct GroundLooks {
    static constexpr std::size_t kSize = 64;
    template <class T>
    using Lane = std::array<T, kSize>;
    template <class T>
    using Lane3 = std::array<Lane<T>, 3>;

    // Asked: film points, when they look in the piece's u, and the triangles by corner.
    alignas(64) Lane<double> x{}, y{}, u{};
    alignas(64) std::array<Lane3<double>, 3> corner{};        // [corner][axis], in the scene
    alignas(64) std::array<Lane<double>, 3> column{}, row{};  // of the corners in the raster

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
