#include "trace/kinetic_check.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "core/low_discrepancy.h"
#include "flight/motion.h"
#include "trace/agreement.h"
#include "trace/discrete.h"
#include "trace/film_distance.h"

namespace overfly {
namespace {

std::uint64_t seed_of(const ImageSample& sample, TimeRange when) {
    std::uint64_t seed = mixed(std::bit_cast<std::uint64_t>(sample.x));
    seed = mixed(seed ^ std::bit_cast<std::uint64_t>(sample.y));
    return mixed(seed ^ std::bit_cast<std::uint64_t>(when.begin_s));
}

TriangleId seen_at(std::span<const VisibleSegment> segments, double time_s) {
    const auto after =
        std::ranges::upper_bound(segments, time_s, {}, [](const VisibleSegment& s) { return s.when.end_s; });
    return after != segments.end() && after->when.begin_s <= time_s ? after->triangle : kNone;
}

}  // namespace

void TraceCheck::run(const MotionPiece& piece, std::span<const ImageSample> samples, TimeRange when,
                     const SegmentLists& lists, TraceCounters& counters) const {
    if (every_ == 0) return;
    const std::size_t first = lists.ends.size() - samples.size();
    const DiscreteTracer discrete(*scene_);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::uint64_t seed = seed_of(samples[i], when);
        if (seed % every_ != 0) continue;
        const double time_s = when.begin_s + uniform(seed) * when.duration_s();
        const TriangleId told = seen_at(lists.of(first + i), time_s);
        const TriangleId found = discrete.visible_at(piece, samples[i].x, samples[i].y, time_s);
        ++counters.checked;
        if (told == found) continue;
        ++counters.differed;
        double nearest = std::numeric_limits<double>::infinity();
        for (const TriangleId t : {told, found}) {
            if (t == kNone) continue;
            const double u = piece.u_at(time_s);
            nearest = std::min(nearest, film_distance_to_sides(scene_->mesh(), t, piece, samples[i], u));
        }
        if (nearest <= kNearEdge_px * film_per_px_) ++counters.differed_by_edge;
    }
}

}  // namespace overfly
