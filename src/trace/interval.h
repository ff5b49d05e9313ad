#pragma once

#include <span>

#include "flight/motion.h"
#include "trace/ray_start.h"
#include "trace/static_bvh.h"
#include "trace/visible_segment.h"

namespace overfly {

// The paper's algorithm (Chapman, Calvert and Dill 1991, procedure Trace) for a scene wholly in relative motion,
// rotation included: each sample's moving line of sight is intersected once with each polygon for a whole stretch of
// the flight, which gives records {polygon, from, to}; they are sorted by start time, and truncated or split where
// another is nearer. Where the paper's boxes swell to hold a moving object at all times, ours stand still and the ray
// sweeps.
class IntervalTracer {
  public:
    // The mesh must outlive the tracer.
    explicit IntervalTracer(const TriangleMesh& mesh);

    // Appends for each sample what it sees while the piece lasts. Outside the exposures segments may be missing or cut
    // short. With a start: of what is met beyond it (kAtStart), when there is one that is positive and finite.
    void trace(const MotionPiece& piece, std::span<const ImageSample> samples, std::span<const TimeRange> exposures,
               SegmentLists& out, TraceCounters& counters, const RayStart* start = nullptr) const;

    // For whoever follows other rays through the same triangles (shadow_tracer.h).
    [[nodiscard]] const StaticBvh& hierarchy() const { return bvh_; }

    [[nodiscard]] std::size_t memory_bytes() const;

  private:
    const TriangleMesh* mesh_;
    StaticBvh bvh_;
};

}  // namespace overfly
