#pragma once

#include <optional>
#include <span>

#include "trace/kinetic_check.h"
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
    // The scene must outlive the tracer. The check, if any, is made of whatever is followed, and counted.
    explicit KineticTracer(const RayScene& scene, std::optional<TraceCheck> check = std::nullopt)
        : scene_(&scene), mesh_(scene.mesh()), check_(check) {}

    // What all samples of a piece share; made once for each piece. `picture` holds all samples.
    // The tracer and the piece must outlive it.
    [[nodiscard]] KineticPiece prepare(const MotionPiece& piece, const FilmBounds& picture) const {
        return {mesh_, piece, picture};
    }

    // Appends for each sample what it sees from the first exposure in the piece to the last, or at the instants where
    // nothing but instants is exposed.
    // Sixteen samples that follow each other should lie close together on the film, and all of them in a small part of
    // it.
    // GUARANTEES: what is told of a time is the same to the bit whichever exposures are asked for after the first.
    void trace(const KineticPiece& piece, std::span<const ImageSample> samples, std::span<const TimeRange> exposures,
               SegmentLists& out, TraceCounters& counters) const;

    // The same for whoever has few samples: prepares the piece for them alone, which takes as long as the mesh is
    // large.
    void trace(const MotionPiece& piece, std::span<const ImageSample> samples, std::span<const TimeRange> exposures,
               SegmentLists& out, TraceCounters& counters) const;

  private:
    struct Following {
        const KineticPiece* piece;
        TimeRange when;
    };
    void look(const MotionPiece& piece, std::span<const ImageSample> samples, std::span<const TimeRange> exposures,
              SegmentLists& out, TraceCounters& counters) const;
    void follow(const Following& what, std::span<const ImageSample> samples, SegmentLists& out,
                TraceCounters& counters) const;

    const RayScene* scene_;
    KineticMesh mesh_;
    std::optional<TraceCheck> check_;
};

}  // namespace overfly
