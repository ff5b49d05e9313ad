#pragma once

#include "flight/camera_path.h"

namespace overfly {

// The camera at one time as its rays need it: they start at `origin` and run along x * right + y * down + view for the
// film point (x, y), as in MotionPiece.
struct RayFrame {
    Point<Scene> origin;
    Vector<Scene> right, down, view;
};

[[nodiscard]] RayFrame ray_frame(const CameraPose& pose);

// How far two cameras disagree on where the ground is in the picture: the largest distance, in film units (half the
// picture's width is 1), between the images of one ground point, over film points of x in [-1, 1], y in
// [-half_height, half_height] and ground points no nearer than distance_m along the exact ray (infinity: sky only).
// Evaluated at 5 x 5 film points with their nearest and their farthest ground, in closed form, nothing linearised.
// Infinite where the fitted camera can't see such a point at all.
[[nodiscard]] double image_error(const RayFrame& exact, const RayFrame& fitted, double half_height, double distance_m);

}  // namespace overfly
