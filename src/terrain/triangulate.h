#pragma once

#include <functional>
#include <span>

#include "geo/scene_frame.h"
#include "terrain/elevation_model.h"
#include "terrain/terrain_mesh.h"

namespace overfly {

// Fills `places` with where the samples of one row are, on the ellipsoid: one per column, the height in it being that
// of the sample above the ellipsoid. Called for many rows at once; a masked sample's place is not looked at.
using LocateRow = std::function<void(int row, std::span<Geodetic> places)>;

// Two triangles per cell of the grid, split along the diagonal that bends less (of equals, the one from the first
// corner); a cell with one masked corner keeps the triangle of its other three, a cell with more is a hole.
// REQUIRES: at least 2x2 samples.
// GUARANTEES: those of TerrainMesh; no triangle has a masked corner; every vertex is a corner of some triangle;
// vertices and triangles follow the raster's rows; same input, same output, whatever the number of threads. Corners run
// anticlockwise seen from above for a raster of either handedness (row order north to south or south to north).
[[nodiscard]] TerrainMesh triangulate(const ElevationModel& model, const SceneFrame& frame, const LocateRow& locate);

}  // namespace overfly
