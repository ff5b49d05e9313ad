#include "trace/discrete_shadow.h"

#include <cmath>

#include "trace/plane_depth.h"

namespace overfly {
namespace {

// Embree sees a point and the surface that it lies on rounded to float, some 2^-24 of their coordinates, and a low sun
// makes a distance to the surface ten times as long. Nothing nearer throws a shadow.
constexpr double kOffSurface = 0x1p-19;

}  // namespace

void DiscreteShadowTracer::trace(const MotionPiece& motion, std::span<const ShadowQuery> queries, ShadowLists& out,
                                 TraceCounters& counters) const {
    for (const ShadowQuery& q : queries) {
        const double time_s = q.when.begin_s;
        const PlaneDepth plane(*q.mesh, q.triangle, *q.motion, q.sample.x, q.sample.y);
        const double depth = plane.at(q.motion->u_at(time_s));
        const double u = motion.u_at(time_s);
        const Vector<Scene> along = depth * motion.direction_at(u, q.sample.x, q.sample.y);
        const Point<Scene> from = motion.origin_at(u) + along;
        const double least_m = kOffSurface * (length(along) + distance(from, scene_->float_centre()));
        ++counters.rays;
        if (std::isfinite(depth) && scene_->is_blocked(from, motion.to_sun.at(u), least_m)) out.dark.push_back(q.when);
        out.ends.push_back(static_cast<std::uint32_t>(out.dark.size()));
    }
}

}  // namespace overfly
