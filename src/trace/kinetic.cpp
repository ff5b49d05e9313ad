#include "trace/kinetic.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "trace/kinetic_walk.h"

namespace overfly {
namespace {

// From the first exposure in the piece to the last.
std::optional<TimeRange> exposed(const MotionPiece& piece, std::span<const TimeRange> exposures) {
    std::optional<TimeRange> all;
    for (const TimeRange& exposure : exposures) {
        const TimeRange open = intersection(exposure, piece.when);
        if (open.duration_s() < 0.0 || open.begin_s >= piece.when.end_s) continue;
        if (!all) all = open;
        all = TimeRange{std::min(all->begin_s, open.begin_s), std::max(all->end_s, open.end_s)};
    }
    return all;
}

}  // namespace

void KineticTracer::trace(const KineticPiece& piece, std::span<const ImageSample> samples,
                          std::span<const TimeRange> exposures, SegmentLists& out, TraceCounters& counters) const {
    counters.rays += samples.size();
    const std::optional<TimeRange> when = exposed(piece.motion(), exposures);
    if (!when || samples.empty()) {
        for (std::size_t i = 0; i < samples.size(); ++i) out.end_sample();
        return;
    }
    counters.restarts += samples.size();
    const std::size_t before = out.segments.size();
    const PieceStretch stretch = {&piece.motion(), piece.motion().u_at(when->begin_s), piece.motion().u_at(when->end_s),
                                  *when};
    KineticWalk(*scene_, piece, stretch, counters).follow(samples, out);
    counters.segments += out.segments.size() - before;
}

void KineticTracer::trace(const MotionPiece& piece, std::span<const ImageSample> samples,
                          std::span<const TimeRange> exposures, SegmentLists& out, TraceCounters& counters) const {
    if (samples.empty()) return;
    trace(prepare(piece, film_bounds(samples)), samples, exposures, out, counters);
}

}  // namespace overfly
