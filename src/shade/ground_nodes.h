#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "shade/air_views.h"
#include "shade/ground_runs.h"
#include "shade/lit_ground.h"

namespace overfly {

// Moments of runs over the ground, many at once.
struct GroundNodes {
    static constexpr std::size_t kSize = AirViews::kSize;

    // Asked: which run, and when in it (its v).
    alignas(64) std::array<std::int32_t, kSize> run{};
    alignas(64) std::array<float, kSize> v{};
    // Answered: planar; 0 where the triangle turns its edge to the eye.
    alignas(64) std::array<float, kSize> depth_m{};
    alignas(64) std::array<float, kSize> from_column{}, from_row{};  // the place in the raster, from corner 0
    // The ground's light, which is still to be seen through the air, and the way there.
    AirViews views;
};

// Answers the first `count`. What LitGround::at says of one place goes for each, up to rounding.
void look_at_ground(const GroundRuns& runs, const LitGround& light, GroundNodes& nodes, std::size_t count);

}  // namespace overfly
