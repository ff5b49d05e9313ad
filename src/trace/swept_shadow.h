#pragma once

#include "trace/shadow_cells.h"
#include "trace/static_bvh.h"

namespace overfly {

// The stretches of each cell in which the line towards the sun meets a triangle before it gets there: in time order and
// apart.
using DarkStretches = std::array<std::vector<Stretch>, kTimeCells>;

// Adds to `dark`, which is empty before. The same for every vector unit that the processor offers.
void gather_shadows(const StaticBvh& bvh, const ShadowCells<0>& cells, DarkStretches& dark, TraceCounters& counters);
void gather_shadows(const StaticBvh& bvh, const ShadowCells<2>& cells, DarkStretches& dark, TraceCounters& counters);

}  // namespace overfly
