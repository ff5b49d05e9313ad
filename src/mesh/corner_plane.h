#pragma once

#include <span>
#include <vector>

#include "core/geometry.h"
#include "geo/frames.h"
#include "mesh/flat_ring.h"

namespace overfly {

// The plane of three corners that are far apart: the first, the one farthest from it, and the one farthest from the
// line through both. (The sum of cross products along the ring would be a better fit, but vanishes for a ring like an
// 8, which is to be told from a line.)
struct CornerPlane {
    double size_m = 0.0;   // from the first corner to the one farthest from it
    double width_m = 0.0;  // of the third from the line of the others
    Vector<Scene> normal;  // a unit vector if width_m isn't 0
};

// REQUIRES: at least one corner.
[[nodiscard]] CornerPlane corner_plane(std::span<const Point<Scene>> corners);

// The corners without the coordinate that says least, so that the two others stay what they are, to the bit.
[[nodiscard]] std::vector<FlatPoint> flattened(std::span<const Point<Scene>> corners, const Vector<Scene>& normal);

}  // namespace overfly
