#pragma once

#include <span>

#include "trace/kinetic_piece.h"
#include "trace/ray_scene.h"
#include "trace/visible_segment.h"

namespace overfly {

// The fast continuous tracer, for one connected mesh in which nothing passes through anything else: instead of asking
// each line of sight anew, it follows the visible point from polygon to polygon through time (design 3.4). A discrete
// ray sets each sample down at the begin of each piece, so errors do not spread, and what is found does not depend on
// which pieces were traced before.
class KineticTracer {
  public:
    // The scene must outlive the tracer.
    explicit KineticTracer(const RayScene& scene) : scene_(&scene), mesh_(scene.mesh()) {}

    // What all samples of a piece share; made once for each piece. `picture` holds all samples.
    // The tracer and the piece must outlive it.
    [[nodiscard]] KineticPiece prepare(const MotionPiece& piece, const FilmBounds& picture) const {
        return {mesh_, piece, picture};
    }

    // Appends for each sample what it sees from the first exposure in the piece to the last.
    // Sixteen samples that follow each other should lie close together on the film, and all of them in a small part of
    // it.
    void trace(const KineticPiece& piece, std::span<const ImageSample> samples, std::span<const TimeRange> exposures,
               SegmentLists& out, TraceCounters& counters) const;

    // The same for whoever has few samples: prepares the piece for them alone, which takes as long as the mesh is
    // large.
    void trace(const MotionPiece& piece, std::span<const ImageSample> samples, std::span<const TimeRange> exposures,
               SegmentLists& out, TraceCounters& counters) const;

  private:
    const RayScene* scene_;
    KineticMesh mesh_;
};

}  // namespace overfly
