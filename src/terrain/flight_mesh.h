#pragma once

#include <functional>

#include "geo/scene_frame.h"
#include "terrain/terrain_mesh.h"

namespace overfly {

// The least error in metres that is allowed anywhere in a ball of the scene. Called for many balls at once.
using AllowedError = std::function<double(Point<Scene> middle, double radius_m)>;

// The ground of a full mesh in as few triangles as the allowed error asks for: right triangles that are halved where
// they would be off by more than is allowed at a place, and wherever that makes a neighbour follow (the stateless
// refinement by vertices of Lindstrom and Pascucci 2001, "Visualization of large terrains made easy", with the error of
// every sample in place of their nested bound). Sample for sample along voids and along the last row and column; a cell
// that nobody halves further is split along the full mesh's diagonal.
// REQUIRES: a mesh of triangulate() in that frame.
// GUARANTEES: those of TerrainMesh. Nothing of the full mesh, at samples or between, is farther from this one than is
// allowed in the ball around its block of 16 x 16 samples; as the triangles interpolate between their corners in the
// grid, and from their planes along the vertical. No cracks: triangles meet along whole sides. Every vertex is a
// sample. Same input, same output, whatever the number of threads.
[[nodiscard]] TerrainMesh triangulate_within(const TerrainMesh& full, const SceneFrame& frame,
                                             const AllowedError& allowed_m);

}  // namespace overfly
