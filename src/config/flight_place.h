#pragma once

#include "config/section.h"
#include "flight/keyframe.h"

namespace overfly::config {

// From below the deepest trench to a quarter of the way to a geostationary orbit.
inline constexpr Range kHeight_m{-20'000, 10'000'000};

// height_above, which stays as it is where the key is absent.
void read_height_above(Section& section, HeightAbove& above);

// lon_deg, lat_deg, height_m and height_above.
[[nodiscard]] FlightPlace read_place(Section& section, HeightAbove above);

}  // namespace overfly::config
