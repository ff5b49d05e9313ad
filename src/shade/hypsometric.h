#pragma once

#include "shade/colour_ramp.h"

namespace overfly {

// The built-in colours: from valley green over dry grass and rock to snow, spread over the terrain's own heights.
// REQUIRES: lowest_m <= highest_m.
[[nodiscard]] ColourRamp hypsometric_ramp(float lowest_m, float highest_m);

}  // namespace overfly
