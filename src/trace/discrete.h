#pragma once

#include <span>

#include "flight/motion.h"
#include "trace/ray_scene.h"
#include "trace/ray_start.h"
#include "trace/visible_segment.h"

namespace overfly {

// The rival: one ray per sample and exposure, at the sample's phase, 16 at a time through Embree. Where float can't
// tell on which side of an edge a ray passes, the edge functions decide in double, so that the answer is the continuous
// tracers'.
class DiscreteTracer {
  public:
    // The scene must outlive the tracer.
    explicit DiscreteTracer(const RayScene& scene) : scene_(&scene) {}

    // Appends for each sample one instant for each exposure whose sampled instant lies in the piece, with kNone where
    // it saw no triangle (behind the start, if there is one). Sixteen samples that follow each other should lie close
    // together on the film.
    void trace(const MotionPiece& piece, std::span<const ImageSample> samples, std::span<const TimeRange> exposures,
               SegmentLists& out, TraceCounters& counters, const RayStart* start = nullptr) const;

    // What is seen at one instant.
    [[nodiscard]] TriangleId visible_at(const MotionPiece& piece, double x, double y, double time_s) const;

  private:
    const RayScene* scene_;
};

}  // namespace overfly
