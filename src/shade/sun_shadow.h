#pragma once

#include <vector>

#include "core/progress.h"
#include "mesh/triangle_mesh.h"
#include "shade/are_blocked.h"

namespace overfly {

// How much of the ground around each vertex the sun reaches, from 0 to 1: the mean over the triangles that meet there,
// falling off linearly to their other corners. An edge of a shadow so is as sharp as the mesh can carry without
// stairs, where one answer per vertex would make saw teeth. Ground that faces away from the sun has none.
// REQUIRES: to_sun is a unit vector. The same for any number of threads.
[[nodiscard]] std::vector<float> sun_share(const TriangleMesh& mesh, Vector<Scene> to_sun,
                                           const AreBlocked& are_blocked, const Progress& progress = {});

}  // namespace overfly
