#pragma once

#include <span>
#include <vector>

#include "core/time_range.h"

namespace overfly {

// The parts of a piece of the motion in each of which one sweep of lines that drift does for all exposures: these are
// equally long, and few enough that lines don't drift too far meanwhile. Parts follow each other and are cut between
// exposures. None: each exposure is to be swept by itself.
// exposures: all that are planned in the piece, one at least. drift_px: of lines during one of them.
[[nodiscard]] std::vector<TimeRange> drift_stretches(TimeRange piece, std::span<const TimeRange> exposures,
                                                     double drift_px);

}  // namespace overfly
