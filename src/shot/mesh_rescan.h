#pragma once

#include "core/progress.h"
#include "flight/closest_approach.h"
#include "geo/scene_frame.h"
#include "terrain/terrain_mesh.h"
#include "trace/ray_scene.h"

namespace overfly {

// How far ground that a full mesh has is from another mesh of the same raster at most, in pixels at the closest
// approach to it: of all samples and, between them, of the middles of all cells' diagonals. Found by looking, and with
// nothing of what made the other mesh: a ray down the vertical of the place meets it; where it is missed at a border,
// the nearest point counts. The same for any number of threads.
[[nodiscard]] double largest_mesh_error_px(const TerrainMesh& full, const SceneFrame& frame, const RayScene& other,
                                           const ClosestApproach& approach, const Progress& progress = {});

}  // namespace overfly
