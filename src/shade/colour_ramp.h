#pragma once

#include <vector>

#include "core/colour.h"

namespace overfly {

// Colours by elevation.
struct ColourRamp {
    struct Stop {
        float elevation_m = 0.0F;
        Rgb colour;  // linear light

        friend bool operator==(const Stop&, const Stop&) = default;
    };
    std::vector<Stop> stops;  // elevations never fall; two at the same one make a step

    // Linear between stops, constant beyond the first and the last; at a step, the upper colour.
    // REQUIRES: at least one stop, elevation_m a number.
    [[nodiscard]] Rgb at(float elevation_m) const;

    friend bool operator==(const ColourRamp&, const ColourRamp&) = default;
};

}  // namespace overfly
