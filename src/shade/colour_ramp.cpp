#include "shade/colour_ramp.h"

#include <algorithm>
#include <cassert>

namespace overfly {

Rgb ColourRamp::at(float elevation_m) const {
    assert(!stops.empty());
    const auto upper = std::ranges::upper_bound(stops, elevation_m, {}, &Stop::elevation_m);
    if (upper == stops.begin()) return stops.front().colour;
    if (upper == stops.end()) return stops.back().colour;
    const Stop& below = *(upper - 1);
    const float t = (elevation_m - below.elevation_m) / (upper->elevation_m - below.elevation_m);
    return (1.0F - t) * below.colour + t * upper->colour;
}

}  // namespace overfly
