#include "trace/kinetic.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "trace/discrete.h"
#include "trace/kinetic_walk.h"

namespace overfly {
namespace {

// From the first exposure in the piece to the last.
std::optional<TimeRange> exposed(const MotionPiece& piece, std::span<const TimeRange> exposures) {
    std::optional<TimeRange> all;
    for (const TimeRange& exposure : exposures) {
        const TimeRange open = intersection(exposure, piece.when);
        if (open.duration_s() <= 0.0) continue;
        if (!all) all = open;
        all = TimeRange{std::min(all->begin_s, open.begin_s), std::max(all->end_s, open.end_s)};
    }
    return all;
}

bool are_instants(std::span<const TimeRange> exposures) {
    return std::ranges::all_of(exposures, [](const TimeRange& e) { return e.duration_s() == 0.0; });
}

}  // namespace

void KineticTracer::trace(const KineticPiece& piece, std::span<const ImageSample> samples,
                          std::span<const TimeRange> exposures, SegmentLists& out, TraceCounters& counters) const {
    if (are_instants(exposures)) return look(piece.motion(), samples, exposures, out, counters);
    const std::optional<TimeRange> when = exposed(piece.motion(), exposures);
    if (!when) {
        for (std::size_t i = 0; i < samples.size(); ++i) out.end_sample();
        return;
    }
    follow({&piece, *when}, samples, out, counters);
}

// From one instant to the next it is as far as a ray is long: nothing is gained by following.
void KineticTracer::look(const MotionPiece& piece, std::span<const ImageSample> samples,
                         std::span<const TimeRange> exposures, SegmentLists& out, TraceCounters& counters) const {
    SegmentLists all;
    DiscreteTracer(*scene_).trace(piece, samples, exposures, all, counters);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        std::ranges::copy_if(all.of(i), std::back_inserter(out.segments),
                             [](const VisibleSegment& s) { return s.triangle != kNone; });
        out.end_sample();
    }
}

void KineticTracer::follow(const Following& what, std::span<const ImageSample> samples, SegmentLists& out,
                           TraceCounters& counters) const {
    if (samples.empty()) return;
    counters.rays += samples.size();
    const std::size_t before = out.segments.size();
    const MotionPiece& motion = what.piece->motion();
    const PieceStretch stretch = {&motion, motion.u_at(what.when.begin_s), motion.u_at(what.when.end_s), what.when};
    // Memory that each thread keeps: fresh pages for each call would take longer than the walk.
    thread_local WalkingSamples walking;
    KineticWalk({scene_, &scene_->mesh(), what.piece, samples, &walking, &counters}, stretch).follow(out);
    counters.segments += out.segments.size() - before;
    if (check_) check_->run(motion, samples, what.when, out, counters);
}

void KineticTracer::trace(const MotionPiece& piece, std::span<const ImageSample> samples,
                          std::span<const TimeRange> exposures, SegmentLists& out, TraceCounters& counters) const {
    if (samples.empty()) return;
    trace(prepare(piece, film_bounds(samples)), samples, exposures, out, counters);
}

}  // namespace overfly
