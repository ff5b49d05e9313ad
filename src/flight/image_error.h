#pragma once

#include "flight/ray_frame.h"
#include "flight/view.h"

namespace overfly {

// How far two cameras disagree on where things are in the picture: the largest distance, in film units (half the
// picture's width is 1), between the images of one point, over film points of x in [-1, 1], y in
// [-half_height, half_height] and points within `reach` along the exact ray. Evaluated at 5 x 5 film points with their
// nearest and their farthest point, in closed form, nothing linearised.
// Infinite where the fitted camera can't see such a point at all.
[[nodiscard]] double image_error(const RayFrame& exact, const RayFrame& fitted, double half_height, Reach reach);

}  // namespace overfly
