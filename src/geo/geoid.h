#pragma once

#include <vector>

#include "geo/frames.h"

namespace overfly {

// Height of a geoid ("sea level") above the ellipsoid, on a global grid in longitude and latitude (EGM96: 15', as
// proj-data installs it). Interpolated bilinearly, which is what PROJ does with the same grid.
struct Geoid {
    int columns = 0, rows = 0;                      // row 0 is the northernmost
    double west_deg = 0.0, north_deg = 0.0;         // of the first sample
    double step_lon_deg = 0.0, step_lat_deg = 0.0;  // both positive; the last column may meet the first
    std::vector<float> undulation_m;                // row by row

    // REQUIRES: the grid is global and not empty.
    [[nodiscard]] double undulation_m_at(Angle lon, Angle lat) const;
};

}  // namespace overfly
