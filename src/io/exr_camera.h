#pragma once

#include <array>

#include "flight/camera_path.h"

namespace overfly {

// The camera as OpenEXR's standard attributes spell it. Matrices are for ROW vectors: (x, y, z, 1) * matrix, with the
// translation in the last row; the world is the Scene frame.
using RowMatrix = std::array<std::array<double, 4>, 4>;

// To the camera of OpenEXR and RenderMan: left-handed, x right, y UP the image, z along the view.
[[nodiscard]] RowMatrix exr_world_to_camera(const CameraPose& pose);

// To the picture: (0, 0) is its upper left corner, (1, 1) its lower right one, once divided by the fourth coordinate,
// which is the planar depth in metres. The third is 1, so that the matrix has an inverse.
[[nodiscard]] RowMatrix exr_world_to_ndc(const CameraPose& pose, int width_px, int height_px);

}  // namespace overfly
