#pragma once

#include <span>

#include "flight/motion.h"
#include "trace/film_box.h"
#include "trace/static_bvh.h"
#include "trace/visible_segment.h"

namespace overfly {

// IntervalTracer with the paper's bounding volumes in place of ours, to show what they cost: boxes that contain their
// triangle all through a motion piece (film_box.h), a hierarchy over them that has to be built for every piece, and a
// ray that stands still in it. Whatever is in a leaf is tested as IntervalTracer does, one sample at a time, and what
// is hidden for the whole piece is skipped alike. Not for rendering.
class InflatedTracer {
  public:
    // Mesh and piece must outlive the tracer.
    InflatedTracer(const TriangleMesh& mesh, const MotionPiece& piece, FilmReach reach);

    // Appends for each sample what it sees all through the piece.
    // REQUIRES: samples within the reach.
    // GUARANTEES: the segments are IntervalTracer's for an exposure as long as the piece.
    void trace(std::span<const ImageSample> samples, SegmentLists& out, TraceCounters& counters) const;

  private:
    const TriangleMesh* mesh_;
    const MotionPiece* piece_;
    StaticBvh bvh_;
};

}  // namespace overfly
