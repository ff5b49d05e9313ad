#pragma once

#include "flight/camera_path.h"

namespace overfly {

// The camera at one time as its rays need it: they start at `origin` and run along x * right + y * down + view for the
// film point (x, y), as in MotionPiece.
struct RayFrame {
    Point<Scene> origin;
    Vector<Scene> right, down, view;
};

[[nodiscard]] inline RayFrame ray_frame(const CameraPose& pose) {
    return {pose.position, pose.tan_half_fov * pose.orientation.x, pose.tan_half_fov * pose.orientation.y,
            pose.orientation.z};
}

}  // namespace overfly
