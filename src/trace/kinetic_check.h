#pragma once

#include <cstdint>
#include <span>

#include "flight/motion.h"
#include "trace/ray_scene.h"
#include "trace/visible_segment.h"

namespace overfly {

// Asks discrete rays again what a continuous tracer has told, for every so many samples at one random time of the
// stretch. Which samples and times depends on the sample and the stretch alone, so a render checks the same for any
// number of threads.
class TraceCheck {
  public:
    // every: of so many samples one is checked; 0: none. A pixel is the width-th part of the picture's width.
    // The scene must outlive it.
    TraceCheck(const RayScene& scene, std::uint64_t every, int width_px)
        : scene_(&scene), every_(every), film_per_px_(2.0 / width_px) {}

    // `lists` has, as its last, what the samples see all through `when`, a part of the piece. Counts those checked,
    // those that differ, and those of them that do so by less than kNearEdge_px (agreement.h) of an edge of one of the
    // two triangles. Safe to call from many threads at once.
    void run(const MotionPiece& piece, std::span<const ImageSample> samples, TimeRange when, const SegmentLists& lists,
             TraceCounters& counters) const;

  private:
    const RayScene* scene_;
    std::uint64_t every_;
    double film_per_px_;
};

}  // namespace overfly
