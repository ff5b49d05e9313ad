#pragma once

#include "trace/line.h"
#include "trace/ray_scene.h"

namespace overfly {

// What a line of sight sees at one instant from a depth on, decided in double by the edge functions: kNone for the sky.
// A discrete ray in float finds the neighbourhood; from there the line is followed across the sides that it passes.
// REQUIRES: least >= 0.
[[nodiscard]] TriangleId look(const RayScene& scene, const Line& line, double least = 0.0);

// What the line sees, from a depth on, of a triangle and those that share a corner with it: where a surface folds, they
// may be one close behind another. kNone if it passes all of them by.
[[nodiscard]] TriangleId look_around(const TriangleMesh& mesh, const Line& line, TriangleId middle, double least = 0.0);

}  // namespace overfly
