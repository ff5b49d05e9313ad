#pragma once

#include <vector>

#include "core/colour.h"

namespace overfly {

// Colours by elevation; on request others where the ground is steep.
struct ColourRamp {
    struct Stop {
        float elevation_m = 0.0F;
        Rgb colour;  // linear light

        friend bool operator==(const Stop&, const Stop&) = default;
    };
    std::vector<Stop> stops;  // elevations never fall; two at the same one make a step

    // Colours of ground too steep for what grows or lies on level ground. Without any the slope makes no difference, as
    // with the file of a user, which is exact.
    std::vector<Stop> steep = {};
    float all_level_cos = 0.97F;  // cosine of the slope up to which `stops` hold alone: 14 degrees
    float all_steep_cos = 0.86F;  // and from which `steep` does: 31 degrees; posts tens of metres apart blunt slopes
    // How far the belts stray from their elevations from place to place (shade/patchiness.h).
    float stray_m = 0.0F;

    // Linear between stops, constant beyond the first and the last; at a step, the upper colour.
    // REQUIRES: at least one stop, elevation_m a number.
    [[nodiscard]] Rgb at(float elevation_m) const;
    // The same on ground whose slope has this cosine.
    [[nodiscard]] Rgb at(float elevation_m, float slope_cos) const;

    friend bool operator==(const ColourRamp&, const ColourRamp&) = default;
};

}  // namespace overfly
