#pragma once

#include "flight/film_drift.h"
#include "trace/sight.h"

namespace overfly {

// The sight over `when` alone, of all surfaces and mirrors, as drifting samples see it.
[[nodiscard]] Sight drifting(const Sight& sight, TimeRange when, const FilmDrift& drift);

// The sight at one time, all through `when`.
[[nodiscard]] Sight standing_still(const Sight& sight, double time_s, TimeRange when);

// The sight during a part of its time, and no longer.
[[nodiscard]] Sight during(const Sight& sight, TimeRange when);

}  // namespace overfly
