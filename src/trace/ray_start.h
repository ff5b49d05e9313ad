#pragma once

#include "flight/motion.h"

namespace overfly {

// Where rays begin that a mirror sends on: nothing counts that they would meet before the plane of the mirror.
// `motion` is that of the rays relative to the mirror, which stands still in `plane`; the ray parameter is the same
// along the unfolded way, whatever it is relative to. Its time holds all exposures that are asked for, though it may be
// cut otherwise than the motion that is traced.
struct RayStart {
    const MotionPiece* motion = nullptr;
    FixedPlane plane;

    // The ray parameter at the plane; not finite or not positive where the ray doesn't come to it.
    [[nodiscard]] double depth_at(double time_s, double x, double y) const {
        const double u = motion->u_at(time_s);
        return dot(plane.normal, plane.on - motion->origin_at(u)) / dot(plane.normal, motion->direction_at(u, x, y));
    }
};

}  // namespace overfly
