#include "trace/agreement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

#include "core/low_discrepancy.h"
#include "core/parallel.h"
#include "trace/film_distance.h"
#include "trace/line.h"

namespace overfly {
namespace {

constexpr long kPairsInTask = 1000;

// One question to both tracers.
struct Pair {
    const MotionPiece* piece;
    ImageSample sample;
    double time_s;

    [[nodiscard]] Line line() const {
        const double u = piece->u_at(time_s);
        return {piece->reference, piece->origin.at(u), piece->direction_at(u, sample.x, sample.y)};
    }
};

TriangleId seen_by(const IntervalTracer& tracer, const Pair& pair) {
    SegmentLists lists;
    TraceCounters counters;
    tracer.trace(*pair.piece, std::array{pair.sample}, std::array{pair.piece->when}, lists, counters);
    for (const VisibleSegment& s : lists.of(0)) {
        if (s.when.contains(pair.time_s)) return s.triangle;
    }
    return kNone;
}

void count(const TriangleMesh& mesh, const Pair& pair, TriangleId a, TriangleId b, double film_per_px,
           Agreement& agreement) {
    ++agreement.pairs;
    if (a == b) {
        ++agreement.same;
        return;
    }
    if (a != kNone && b != kNone) {
        const double depth_a = depth_on(mesh, a, pair.line());
        const double depth_b = depth_on(mesh, b, pair.line());
        if (std::abs(depth_a - depth_b) <= kSameDepth * std::max(depth_a, depth_b)) {
            ++agreement.same_depth;
            return;
        }
    }
    double film = std::numeric_limits<double>::infinity();
    for (const TriangleId t : {a, b}) {
        if (t != kNone)
            film = std::min(film,
                            film_distance_to_sides(mesh, t, *pair.piece, pair.sample, pair.piece->u_at(pair.time_s)));
    }
    ++(film <= kNearEdge_px * film_per_px ? agreement.near_edge : agreement.unexplained);
}

}  // namespace

Agreement compare(const DiscreteTracer& discrete, const IntervalTracer& interval, const TriangleMesh& mesh,
                  const Motion& motion, const AgreementOptions& options) {
    const TimeRange times = motion.times();
    const double film_height = static_cast<double>(options.height_px) / options.width_px;
    Agreement total;
    std::mutex mutex;
    const long tasks = (options.pairs + kPairsInTask - 1) / kPairsInTask;
    parallel_for(static_cast<std::size_t>(tasks), [&](std::size_t task) {
        Agreement part;
        const long begin = static_cast<long>(task) * kPairsInTask;
        for (long i = begin; i < std::min(options.pairs, begin + kPairsInTask); ++i) {
            const std::uint64_t seed = mixed(options.seed) + 3 * static_cast<std::uint64_t>(i);
            const double time_s = times.begin_s + uniform(seed) * times.duration_s();
            const ImageSample sample = {2.0 * uniform(seed + 1) - 1.0, film_height * (2.0 * uniform(seed + 2) - 1.0),
                                        0.0};
            const Pair pair = {&motion.piece_at(time_s), sample, time_s};
            const TriangleId a = discrete.visible_at(*pair.piece, sample.x, sample.y, time_s);
            count(mesh, pair, a, seen_by(interval, pair), 2.0 / options.width_px, part);
        }
        const std::scoped_lock lock(mutex);
        total.pairs += part.pairs;
        total.same += part.same;
        total.same_depth += part.same_depth;
        total.near_edge += part.near_edge;
        total.unexplained += part.unexplained;
    });
    return total;
}

}  // namespace overfly
