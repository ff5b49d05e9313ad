#pragma once

#include "shade/daylight.h"
#include "shade/lit_ground.h"
#include "terrain/grids.h"

namespace overfly::testing {

// A plain of one colour, and a day over it.
struct PlainView {
    Grid grid;
    TerrainMesh mesh = [&] {
        const ElevationModel model = flat(3, 3);
        return triangulate(model, frame_at(grid), locate_in(grid, model));
    }();
    GroundLight lit = [&] {
        GroundLight out;
        out.radiance.assign(mesh.positions.size(), {0.3F, 0.4F, 0.2F});
        out.without_sun = out.radiance;
        return out;
    }();
    LitGround light{mesh, lit};
    Daylight day{{.sun_azimuth = Angle::degrees(115), .sun_elevation = Angle::degrees(22)}};
};

}  // namespace overfly::testing
