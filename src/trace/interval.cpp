#include "trace/interval.h"

#include "trace/nearest_records.h"
#include "trace/swept_ray.h"

namespace overfly {
namespace {

// Records that meet at a vertex are cut at the roots of different edges, each exact to a few roundings of the cell; a
// gap no longer than this (a thousand such roundings) is rounding, not sky.
constexpr double kGap = 1e-12;

// Joins the records of a cell to what was seen before it, and appends them.
class Timeline {
  public:
    Timeline(const MotionPiece& piece, std::vector<VisibleSegment>& out)
        : piece_(&piece), out_(&out), first_(out.size()) {}

    void add(std::size_t cell, const CellRecord& record) {
        const double begin = TimeCells::piece_u(cell, record.begin);
        const double end = TimeCells::piece_u(cell, record.end);
        const bool touches = out_->size() > first_ && begin - last_ <= kGap;
        const double begin_s = touches ? out_->back().when.end_s : piece_->time_at(begin);
        last_ = end;
        if (touches && out_->back().triangle == record.triangle) {
            out_->back().when.end_s = piece_->time_at(end);
        } else if (end > begin) {
            out_->push_back({record.triangle, {begin_s, piece_->time_at(end)}});
        }
    }
    [[nodiscard]] std::size_t count() const { return out_->size() - first_; }

  private:
    const MotionPiece* piece_;
    std::vector<VisibleSegment>* out_;
    std::size_t first_;
    double last_ = 0.0;  // end of the latest record, in the piece's u
};

}  // namespace

IntervalTracer::IntervalTracer(const TerrainMesh& mesh) : mesh_(&mesh), bvh_(build_static_bvh(mesh)) {}

void IntervalTracer::trace(const MotionPiece& piece, std::span<const ImageSample> samples,
                           std::span<const TimeRange> exposures, SegmentLists& out, TraceCounters& counters) const {
    const TimeCells cells(piece);
    const std::uint32_t active = cells.overlapping(exposures);
    CellRecords records;
    std::vector<CellRecord> scratch;
    for (const ImageSample& sample : samples) {
        const SweptRay ray = {mesh_, &bvh_, &cells, sample.x, sample.y, active};
        gather_records(ray, records, counters);
        Timeline timeline(piece, out.segments);
        for (std::size_t cell = 0; cell < kTimeCells; ++cell) {
            for (const CellRecord& r : nearest_records(ray, cell, records[cell], scratch)) timeline.add(cell, r);
            records[cell].clear();
        }
        ++counters.rays;
        counters.segments += timeline.count();
        out.end_sample();
    }
}

std::size_t IntervalTracer::memory_bytes() const {
    return bvh_.nodes.size() * sizeof(StaticBvh::Node) + bvh_.triangles.size() * sizeof(TriangleId);
}

}  // namespace overfly
