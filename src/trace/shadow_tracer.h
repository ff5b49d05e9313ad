#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "flight/motion.h"
#include "trace/static_bvh.h"
#include "trace/visible_segment.h"

namespace overfly {

// What a sample sees for a while, of which is asked when the sun doesn't reach it.
struct ShadowQuery {
    ImageSample sample;
    const TriangleMesh* mesh = nullptr;  // of the surface that is seen; each surface has its own
    TriangleId triangle = kNone;
    const MotionPiece* motion = nullptr;  // of the rays relative to that surface; holds `when`
    TimeRange when;
};

// When each query's point is in shadow: query by query, in time order and apart. An instant is answered by itself.
struct ShadowLists {
    std::vector<TimeRange> dark;
    std::vector<std::uint32_t> ends;  // of each query's run in dark

    void clear() {
        dark.clear();
        ends.clear();
    }
    [[nodiscard]] std::span<const TimeRange> of(std::size_t query) const {
        const std::uint32_t begin = query == 0 ? 0 : ends[query - 1];
        return std::span(dark).subspan(begin, ends[query] - begin);
    }
};

// The shadow that one surface throws where the line of sight wanders over another, or over the surface itself, exact in
// time (design 3.3): the line from the point that is seen towards the sun has Pluecker coordinates that are polynomials
// in time, so that its passing of an edge is a root like any other.
class ShadowTracer {
  public:
    // The surface that stands in the light. Both must outlive the tracer.
    ShadowTracer(const TriangleMesh& mesh, const StaticBvh& bvh) : mesh_(&mesh), bvh_(&bvh) {}

    // Appends for each query the stretches of its `when` in which a triangle stands between the point that is seen and
    // the sun. `motion` is that of the rays relative to the surface that stands in the light, with its to_sun.
    // The seen triangle throws no shadow on itself; ground that faces away from the sun need not be asked for.
    // REQUIRES: `motion` holds the `when` of all queries. A query about this very surface comes with the same motion,
    // and its sample sees the triangle all through `when`. Sixteen queries that follow each other should see places
    // close together.
    // GUARANTEES: each query's answer is the same whatever else is asked. Times are exact to a few roundings of the
    // piece but where the lines of sight or of the sun graze the ground; what lasts less than kBlink of it is left out.
    void trace(const MotionPiece& motion, std::span<const ShadowQuery> queries, ShadowLists& out,
               TraceCounters& counters) const;

  private:
    const TriangleMesh* mesh_;
    const StaticBvh* bvh_;
};

}  // namespace overfly
