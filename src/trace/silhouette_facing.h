#pragma once

#include <array>
#include <span>
#include <vector>

#include "trace/kinetic_scene.h"
#include "trace/silhouette.h"

namespace overfly {

// A mesh and the camera's motion past it in single precision, in one frame (StrideScene).
struct FacingTask {
    const TriangleMesh* mesh;
    std::span<const std::array<float, 4>> places;  // by vertex
    const Quadratic3<float>& origin;
};

// From which side the camera sees each triangle during the piece. REQUIRES: the task is of this piece.
// The same for every vector unit: what single precision leaves open is decided in double.
[[nodiscard]] std::vector<Facing> facing_over(const FacingTask& task, const MotionPiece& piece);

}  // namespace overfly
