#pragma once

#include "core/angle.h"

namespace overfly {

// How the terrain is lit. Strengths are factors on a daylight that is balanced at 1.
struct Look {
    Angle sun_azimuth = Angle::degrees(315.0);   // clockwise from north, at the scene's origin
    Angle sun_elevation = Angle::degrees(35.0);  // above the horizon there
    double sun_strength = 1.0;
    double sky_strength = 1.0;       // of the sky, its light on the ground, and the light that haze adds
    double visibility_m = 60'000.0;  // distance at which haze leaves 2 % of the contrast (Koschmieder 1924); 0: no haze
    double exposure_stops = 0.0;

    friend constexpr bool operator==(const Look&, const Look&) = default;
};

}  // namespace overfly
