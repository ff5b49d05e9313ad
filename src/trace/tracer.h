#pragma once

#include <variant>

#include "trace/discrete.h"
#include "trace/interval.h"

namespace overfly {

// The ways to answer "which polygon is seen when", behind one call.
using Tracer = std::variant<DiscreteTracer, IntervalTracer>;

// start: where the rays begin, if not at the camera.
inline void trace(const Tracer& tracer, const MotionPiece& piece, std::span<const ImageSample> samples,
                  std::span<const TimeRange> exposures, SegmentLists& out, TraceCounters& counters,
                  const RayStart* start = nullptr) {
    std::visit([&](const auto& t) { t.trace(piece, samples, exposures, out, counters, start); }, tracer);
}

}  // namespace overfly
