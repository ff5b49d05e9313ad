#include "trace/interval.h"

#include <algorithm>
#include <optional>

#include "trace/cell_starts.h"
#include "trace/nearest_records.h"
#include "trace/swept_ray.h"

namespace overfly {
namespace {

// Records that meet at a vertex are cut at the roots of different edges, each exact to a few roundings of the cell; a
// gap no longer than this (a thousand such roundings) is rounding, not sky.
constexpr double kGap = 1e-12;  // of the piece

// Appends the records of one cell, which are in time order and apart, as segments.
void append_segments(const TimeCells& cells, std::size_t cell, std::span<const CellRecord> records,
                     std::vector<VisibleSegment>& out) {
    const std::size_t first = out.size();
    const double piece_per_cell = cells.to[cell] - cells.from[cell];
    double last = 0.0;  // end of the latest record, in the cell's u
    for (const CellRecord& record : records) {
        const bool touches = out.size() > first && (record.begin - last) * piece_per_cell <= kGap;
        const double begin_s = touches ? out.back().when.end_s : cells.time_s(cell, record.begin);
        const double end_s = cells.time_s(cell, record.end);
        if (touches && out.back().triangle == record.triangle) {
            out.back().when.end_s = end_s;
        } else if (end_s > begin_s || cells.exposure_of(cell).duration_s() == 0.0) {
            out.push_back({record.triangle, {begin_s, end_s}});
        } else {
            continue;  // shorter than time can tell
        }
        last = record.end;
    }
}

// The exposures that lie in the piece, cut off at its ends, by as many as are traced together.
std::vector<TimeCells> cells_of(const MotionPiece& piece, std::span<const TimeRange> exposures) {
    std::vector<TimeRange> within;
    for (const TimeRange& exposure : exposures) {
        const TimeRange open = intersection(exposure, piece.when);
        if (open.duration_s() >= 0.0) within.push_back(open);
    }
    std::vector<TimeCells> cells;
    for (std::size_t first = 0; first < within.size(); first += kTimeCells) {
        const std::size_t count = std::min(kTimeCells, within.size() - first);
        cells.emplace_back(piece, std::span(within).subspan(first, count));
    }
    return cells;
}

// Follows samples through cells and appends what each of them sees.
class Follower {
  public:
    Follower(const TriangleMesh& mesh, const StaticBvh& bvh, const RayStart* start, TraceCounters& counters)
        : mesh_(&mesh), bvh_(&bvh), start_(start), counters_(&counters) {}

    // REQUIRES: no more samples than cells.samples_together(). Calls end_sample() after each.
    template <class EndSample>
    void follow(const TimeCells& cells, std::span<const ImageSample> samples, std::vector<VisibleSegment>& out,
                const EndSample& end_sample) {
        SweptRays rays(*mesh_, *bvh_, cells, samples);
        std::optional<CellStarts> starts;
        if (start_ != nullptr) {
            rays.starts = &starts.emplace(*start_, rays);
            rays.active = starts->open();
        }
        gather_records(rays, records_, *counters_);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            for (std::size_t k = 0; k < cells.exposures.size(); ++k) {
                const std::size_t cell = i * cells.exposures.size() + k;
                append_segments(cells, cell, nearest_records(rays, cell, records_[cell], scratch_), out);
                records_[cell].clear();
            }
            end_sample();
        }
    }

  private:
    const TriangleMesh* mesh_;
    const StaticBvh* bvh_;
    const RayStart* start_;
    TraceCounters* counters_;
    CellRecords records_;
    std::vector<CellRecord> scratch_;
};

}  // namespace

IntervalTracer::IntervalTracer(const TriangleMesh& mesh) : mesh_(&mesh), bvh_(build_static_bvh(mesh)) {}

void IntervalTracer::trace(const MotionPiece& piece, std::span<const ImageSample> samples,
                           std::span<const TimeRange> exposures, SegmentLists& out, TraceCounters& counters,
                           const RayStart* start) const {
    const std::vector<TimeCells> all_cells = cells_of(piece, exposures);
    const std::size_t before = out.segments.size();
    Follower follower(*mesh_, bvh_, start, counters);
    if (all_cells.size() == 1) {
        const std::size_t together = all_cells[0].samples_together();
        for (std::size_t first = 0; first < samples.size(); first += together) {
            const auto group = samples.subspan(first, std::min(together, samples.size() - first));
            follower.follow(all_cells[0], group, out.segments, [&] { out.end_sample(); });
        }
    } else {
        // More exposures than one walk can follow: walk after walk, each sample's segments in the order of time.
        for (const ImageSample& sample : samples) {
            for (const TimeCells& cells : all_cells) follower.follow(cells, std::span(&sample, 1), out.segments, [] {});
            out.end_sample();
        }
    }
    counters.rays += samples.size();
    counters.segments += out.segments.size() - before;
}

std::size_t IntervalTracer::memory_bytes() const {
    return bvh_.nodes.size() * sizeof(StaticBvh::Node) + bvh_.triangles.size() * sizeof(TriangleId);
}

}  // namespace overfly
