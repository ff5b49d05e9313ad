#pragma once

#include "flight/keyframe.h"
#include "geo/frames.h"

namespace overfly {

// How a camera with this attitude is turned, against the horizon of the axes east, north and up (columns x, y and z,
// as SceneFrame::local_axes gives them). Any pitch and roll: heading and roll still tell up at pitch +-90 degrees.
[[nodiscard]] Rotation<Scene, Camera> orientation(const Attitude& attitude, const Rotation<Scene, Scene>& local_axes);

// The attitude without roll that looks along `direction`: heading in (-180, 180], pitch in [-90, 90] degrees. Straight
// up or down any heading would do and rounding chooses one; for the zero vector, level north.
[[nodiscard]] Attitude attitude_towards(Vector<Scene> direction, const Rotation<Scene, Scene>& local_axes);

// `angle` and whole turns: the one nearest to `reference`.
[[nodiscard]] Angle nearest_turn(Angle angle, Angle reference);

}  // namespace overfly
