#pragma once

#include <span>
#include <vector>

#include "core/error.h"
#include "flight/keyframe.h"

namespace overfly {

// Everything that keeps keyframes from being flown over these surroundings: numbers that
// are not finite or out of range, times that do not increase, a height above ground where there is no ground, a camera
// below the ground, a camera in its own target, neighbours a quarter of the Earth apart (the way between them is not
// clear). A camera off the terrain is fine where its height is counted from sea level or the ellipsoid.
// `places` says where each keyframe stands in its document; it may be shorter, or empty.
// GUARANTEES: CameraPath's requirements hold if nothing is found.
[[nodiscard]] std::vector<Problem> check_keyframes(const std::vector<Keyframe>& keyframes,
                                                   std::span<const Place> places, const Surroundings& surroundings);

}  // namespace overfly
