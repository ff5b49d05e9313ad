#pragma once

#include <optional>

#include "flight/keyframe.h"

namespace overfly {

// The place with its height above the ellipsoid; nothing where it is counted from the ground and there is none.
[[nodiscard]] std::optional<Geodetic> resolve_place(const FlightPlace& place, const Surroundings& surroundings);

}  // namespace overfly
