#pragma once

#include "trace/ray_scene.h"
#include "trace/shadow_tracer.h"

namespace overfly {

// The rival of ShadowTracer: one ray towards the sun for each query, which has to be an instant.
class DiscreteShadowTracer {
  public:
    // The surface that stands in the light. The scene must outlive the tracer.
    explicit DiscreteShadowTracer(const RayScene& scene) : scene_(&scene) {}

    // As ShadowTracer::trace. REQUIRES: the queries are instants.
    void trace(const MotionPiece& motion, std::span<const ShadowQuery> queries, ShadowLists& out,
               TraceCounters& counters) const;

  private:
    const RayScene* scene_;
};

}  // namespace overfly
