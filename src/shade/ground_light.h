#pragma once

#include <vector>

#include "core/colour.h"
#include "core/progress.h"
#include "shade/are_blocked.h"
#include "shade/colour_ramp.h"
#include "shade/daylight.h"
#include "terrain/terrain_mesh.h"

namespace overfly {

// What the ground sends to the camera, before the air between: light that fixed ground under a fixed sky reflects to
// every side alike, and so is computed once per vertex and not per frame.
struct GroundLight {
    std::vector<Rgb> radiance;     // of each vertex of the mesh
    std::vector<Rgb> without_sun;  // the same where something stands before the sun

    // What they are made of, where that is asked for.
    std::vector<Rgb> albedo;
    std::vector<Rgb> sunlight;  // of the sun, as if nothing threw shadows
};

// Who finds the shadows that the ground casts on itself: the light of the vertices, or whoever follows the lines of
// sight; then `radiance` is that of sunlit ground throughout.
enum class GroundShadows { Baked, Traced };

struct GroundLightOptions {
    GroundShadows shadows = GroundShadows::Baked;
    bool with_parts = false;
};

// Albedo, times sun (with the shadows of the terrain) plus the sky that the vertex sees, plus a first bounce from the
// ground that hides the rest of it. The same for any number of threads.
[[nodiscard]] GroundLight light_ground(const TerrainMesh& mesh, const ColourRamp& colours, const Daylight& day,
                                       const AreBlocked& are_blocked, const GroundLightOptions& options = {},
                                       const Progress& progress = {});

// Radiance of the ground around a place, as far as it lights what stands there: taken as level and in the sun, for
// where much of it is seen, some is.
[[nodiscard]] Rgb ground_around(const Daylight& day);

// Unit normals of the vertices, upward: those of the triangles around, weighted by area.
[[nodiscard]] std::vector<Vector<Scene>> vertex_normals(const TerrainMesh& mesh);

}  // namespace overfly
