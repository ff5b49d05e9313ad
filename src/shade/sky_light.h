#pragma once

#include <span>
#include <vector>

#include "core/progress.h"
#include "shade/are_blocked.h"
#include "shade/daylight.h"
#include "terrain/terrain_mesh.h"

namespace overfly {

// Light of the sky on a vertex, and the sky that it does not get because ground stands before it.
struct SkyLight {
    Rgb irradiance;             // over pi
    float ground_share = 0.0F;  // of all light that the vertex could get from around: what it sees of other ground
};

// For each vertex. Level ground that sees all of the sky has irradiance day.sky(). The obstructed part of the sky is
// averaged over neighbouring vertices: it changes little from one to the next, and so few rays are enough.
// normals: unit vectors, one for each vertex. The same for any number of threads.
[[nodiscard]] std::vector<SkyLight> sky_light(const TerrainMesh& mesh, std::span<const Vector<Scene>> normals,
                                              const Daylight& day, const AreBlocked& are_blocked,
                                              const Progress& progress = {});

}  // namespace overfly
