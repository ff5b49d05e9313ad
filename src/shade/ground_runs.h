#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "flight/motion.h"
#include "shade/ground_triangles.h"

namespace overfly {

// What lines of sight do on the ground while each of them sees one triangle: runs, many at once, in the layout that
// vector units like. A run's time is v, from 0 to 1.
struct GroundRuns {
    static constexpr std::size_t kSize = GroundTriangles::kSize;
    template <class T>
    using Lane = GroundTriangles::Lane<T>;

    // Asked: film points, begin and end in the piece's u, and the triangles.
    alignas(64) Lane<double> x{}, y{}, from_u{}, to_u{};
    GroundTriangles triangles;
    alignas(64) Lane<std::int32_t> in_shadow{};  // 1: it is; else 0

    // Answered. Numerators and what they are over, quadratics of v: c[0] + v (c[1] + v c[2]). As rays move by
    // quadratics of time and a run is short, they follow the run closely: at both ends and in the middle they are
    // exact.
    struct Quadratic {
        std::array<Lane<float>, 3> c{};
        [[nodiscard]] float at(std::size_t k, float v) const { return c[0][k] + v * (c[1][k] + v * c[2][k]); }
    };
    alignas(64) Quadratic columns{}, rows{}, depths{}, over{};  // columns and rows from corner 0; planar depths
    // Between which those are that the triangle has.
    alignas(64) Lane<float> least_column{}, most_column{}, least_row{}, most_row{};
    // How many cells of the raster it passes.
    alignas(64) Lane<float> cells{};
    // Linear in v: at the begin, and what is added until the end. Of the ray: its length by planar depth, and the
    // cosine of its angle to the sun.
    struct Linear {
        Lane<float> from{}, more{};
        [[nodiscard]] float at(std::size_t k, float v) const { return from[k] + v * more[k]; }
    };
    alignas(64) Linear per_depth{}, towards_sun{};
    alignas(64) Lane<float> from_height_m{};  // of the camera, half way, as height_over_ball_m counts from lowest_m
};

// Answers the first `count`. to_sun: a unit vector.
void follow_ground(const MotionPiece& scene, Vector<Scene> to_sun, double lowest_m, GroundRuns& runs,
                   std::size_t count);

}  // namespace overfly
