#pragma once

#include <cmath>

#include "core/geometry.h"
#include "geo/frames.h"

namespace overfly {

struct LocalFrame {
    Vector<Scene> x, y, z;
};

// Two unit vectors square to z and to each other. REQUIRES: z is a unit vector.
// (Duff et al. 2017, "Building an Orthonormal Basis, Revisited".)
[[nodiscard]] inline LocalFrame frame_around(Vector<Scene> z) {
    const double sign = std::copysign(1.0, z.z);
    const double a = -1.0 / (sign + z.z);
    const double b = z.x * z.y * a;
    return {{1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

}  // namespace overfly
