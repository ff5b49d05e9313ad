#pragma once

#include <functional>

#include "geo/scene_frame.h"
#include "terrain/elevation_model.h"
#include "terrain/terrain_mesh.h"
#include "terrain/triangulate.h"

namespace overfly {

// The least error in metres that is allowed anywhere in a ball of the scene. Called for many balls at once.
using AllowedError = std::function<double(Point<Scene> middle, double radius_m)>;

// As few triangles as the allowed error asks for: right triangles that are halved where a sample would be off by more
// than is allowed at its place, and wherever that makes a neighbour follow (the stateless refinement by vertices of
// Lindstrom and Pascucci 2001, "Visualization of large terrains made easy", with the error of every sample in place of
// their nested bound). Sample for sample along voids and along the last row and
// column; as in triangulate() a cell with one masked corner keeps a triangle.
// REQUIRES: at least 2x2 samples.
// GUARANTEES: those of TerrainMesh. No measured sample that a triangle lies over is farther from it, as the triangle
// interpolates between its corners in the grid, than is allowed in the ball around the sample's block of 16 x 16. No
// cracks: triangles meet along whole sides. Every vertex is a sample. Same input, same output, whatever the number of
// threads.
[[nodiscard]] TerrainMesh triangulate_within(const ElevationModel& model, const SceneFrame& frame,
                                             const LocateRow& locate, const AllowedError& allowed_m);

}  // namespace overfly
