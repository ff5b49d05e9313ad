#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "flight/motion.h"
#include "shade/air_views.h"
#include "shade/daylight.h"
#include "shade/lit_ground.h"

namespace overfly {

// Moments of lines of sight that meet no triangle, many at once.
struct SkyNodes {
    static constexpr std::size_t kSize = AirViews::kSize;

    // Asked: film points, and the time as the piece's u.
    alignas(64) std::array<double, kSize> x{}, y{}, u{};
    // Answered. 1: it is the round Earth beyond the data that is seen; 0: the sky.
    alignas(64) std::array<std::int32_t, kSize> is_earth{};
    alignas(64) AirViews::Lane rise{};  // sine of the elevation, at least 0
    AirViews views;                     // the light that is seen, and of the Earth the way there
};

// Answers the first `count`. What Daylight::background says of one, and FarGround with Daylight::through_air, goes for
// each, up to rounding. scene: the rays relative to the scene. light: of the ground that the Earth begins beyond.
void look_at_sky(const MotionPiece& scene, const Daylight& day, const LitGround& light, SkyNodes& nodes,
                 std::size_t count);

}  // namespace overfly
