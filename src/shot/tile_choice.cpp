#include "shot/tile_choice.h"

#include <algorithm>

namespace overfly {
namespace {

// Where a tile is tried: runs of neighbours, as many as share a walk, in so many places of it.
constexpr std::size_t kTriedRuns = 4;
constexpr std::size_t kRun = 4;

// Nanoseconds, of one thread of a 2.x GHz server processor with AVX-512; only their ratios matter. Fitted to shots from
// a hover to a fast pan; the command is in docs/method.md.
constexpr double kBoxTest_ns = 20.0;
constexpr double kTriangleTest_ns = 150.0;
constexpr double kSegment_ns = 70.0;    // sorting it, and its light
constexpr double kCrossing_ns = 400.0;  // from one triangle to another while the shutter is open: roots
constexpr double kSample_ns = 125.0;    // a ray, and its light

}  // namespace

bool lines_are_cheaper(const TracerPair& tracers, const PreparedSight& prepared, std::span<const ImageSample> lines,
                       std::span<const TimeRange> exposures, TraceCounters& counters) {
    TraceCounters tried;
    std::size_t followed = 0;
    const std::size_t step = std::max<std::size_t>(lines.size() / kTriedRuns, 1);
    for (std::size_t first = 0; first < lines.size(); first += step) {
        const auto run = lines.subspan(first, std::min(kRun, lines.size() - first));
        SurfaceSegmentLists lists;
        tracers.continuous->trace(prepared, run, exposures, lists, tried);
        followed += run.size();
    }
    counters += tried;
    const auto per_line = [&](std::uint64_t count) {
        return static_cast<double>(count) / static_cast<double>(followed);
    };
    const auto seen_at_rest = static_cast<double>(exposures.size());
    const double line_ns = kBoxTest_ns * per_line(tried.box_tests) + kTriangleTest_ns * per_line(tried.triangle_tests) +
                           kSegment_ns * per_line(tried.segments) +
                           kCrossing_ns * std::max(per_line(tried.segments) - seen_at_rest, 0.0);
    return tracers.lines * line_ns <= tracers.samples * (kSample_ns * seen_at_rest);
}

}  // namespace overfly
