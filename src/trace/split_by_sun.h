#pragma once

#include <span>
#include <vector>

#include "trace/sight.h"
#include "trace/surface_segment.h"

namespace overfly {

// What samples see, split where it comes into the shadow of a surface or out of it (design 3.3). `seen` are the
// segments of each sample, all of one sight; surfaces without a blocker throw no shadows.
void split_by_sun(std::span<const Surface> surfaces, const Sight& sight, std::span<const ImageSample> samples,
                  std::vector<std::vector<SurfaceSegment>>& seen, TraceCounters& counters);

}  // namespace overfly
