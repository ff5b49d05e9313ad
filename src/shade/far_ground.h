#pragma once

#include <optional>

#include "core/colour.h"
#include "mesh/triangle_mesh.h"
#include "shade/ground_light.h"

namespace overfly {

// The Earth beyond the data: a smooth ball as high as the border of the terrain on average, and as bright. Seen from
// the air terrain so goes on to the horizon instead of ending in the sky.
struct FarGround {
    double height_m = 0.0;  // as height_over_ball_m counts
    Rgb radiance;

    // REQUIRES: light is that of the mesh. Only the lower half of the border counts: the plain between the mountains.
    FarGround(const TriangleMesh& mesh, const GroundLight& light);

    // How far a view along a unit direction is from it; nothing if it does not meet it, or starts below.
    [[nodiscard]] std::optional<double> distance_m(Point<Scene> from, Vector<Scene> direction) const;
};

}  // namespace overfly
