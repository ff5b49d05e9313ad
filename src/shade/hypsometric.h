#pragma once

#include "shade/colour_ramp.h"

namespace overfly {

// The built-in colours: dry basin, grass, forest, alpine meadow, rock and snow, spread over the terrain's own heights;
// where it is steep, bare soil and rock. Reflectances are those of natural ground, a little lighter.
// REQUIRES: lowest_m <= highest_m.
[[nodiscard]] ColourRamp hypsometric_ramp(float lowest_m, float highest_m);

}  // namespace overfly
