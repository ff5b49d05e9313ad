#include "shade/colour_ramp.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace overfly {
namespace {

Rgb between_stops(std::span<const ColourRamp::Stop> stops, float elevation_m) {
    assert(!stops.empty());
    const auto upper = std::ranges::upper_bound(stops, elevation_m, {}, &ColourRamp::Stop::elevation_m);
    if (upper == stops.begin()) return stops.front().colour;
    if (upper == stops.end()) return stops.back().colour;
    const ColourRamp::Stop& below = *(upper - 1);
    const float t = (elevation_m - below.elevation_m) / (upper->elevation_m - below.elevation_m);
    return (1.0F - t) * below.colour + t * upper->colour;
}

}  // namespace

Rgb ColourRamp::at(float elevation_m) const { return between_stops(stops, elevation_m); }

Rgb ColourRamp::at(float elevation_m, float slope_cos) const {
    const Rgb level = at(elevation_m);
    if (steep.empty() || slope_cos >= all_level_cos) return level;
    const float t = std::clamp((all_level_cos - slope_cos) / (all_level_cos - all_steep_cos), 0.0F, 1.0F);
    return (1.0F - t) * level + t * between_stops(steep, elevation_m);
}

}  // namespace overfly
