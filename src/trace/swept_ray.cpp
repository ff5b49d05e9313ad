// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/swept_ray.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "trace/box_walk-inl.h"
#include "trace/cell_starts.h"
#include "trace/inside_stretches.h"
#include "trace/plane_depth.h"
#include "trace/swept_ray.h"
#include "trace/triangle_sides-inl.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {

// The line of each cell's film point: x * right + y * down + view, part by part.
void combine(const SweptRays& ray, const QuarticVectors& right, const QuarticVectors& down, const QuarticVectors& view,
             QuarticVectors& out) {
    const Doubles d;
    const std::size_t lanes = hn::Lanes(d);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t j = 0; j < 5; ++j) {
            for (std::size_t first = 0; first < kTimeCells; first += lanes) {
                const auto r = hn::Mul(hn::Load(d, &ray.x[first]), hn::Load(d, &right[axis][j][first]));
                const auto e = hn::Mul(hn::Load(d, &ray.y[first]), hn::Load(d, &down[axis][j][first]));
                hn::Store(hn::Add(hn::Add(r, e), hn::Load(d, &view[axis][j][first])), d, &out[axis][j][first]);
            }
        }
    }
}

CellLines lines_of(const SweptRays& ray) {
    CellLines lines;
    const TimeCells& c = *ray.cells;
    combine(ray, c.right.direction, c.down.direction, c.view.direction, lines.direction);
    combine(ray, c.right.moment, c.down.moment, c.view.moment, lines.moment);
    return lines;
}

// Records where the lines of sight pass through triangles.
class RecordWalk {
  public:
    RecordWalk(const SweptRays& ray, CellRecords& records, TraceCounters& counters)
        : ray_(&ray),
          records_(&records),
          counters_(&counters),
          lines_(lines_of(ray)),
          sides_(lines_),
          depths_(ray.active) {}

    void run() {
        Sweep sweep;
        sweep_origins({&ray_->cells->origin_low, &ray_->cells->origin_high, ray_->cells->piece->reference},
                      ray_->bvh->slack_m, sweep);
        sweep_directions<4>(lines_.direction, sweep);
        if (ray_->starts != nullptr) begin_at(*ray_->starts);
        BoxWalk(*ray_->bvh, sweep, depths_, *counters_, *this).run();
    }

    // What BoxWalk does with a triangle.
    void operator()(TriangleId triangle, std::uint32_t cells) {
        ++counters_->triangle_tests;
        const TriangleMesh& mesh = *ray_->mesh;
        const SideMasks masks = sides_.evaluate(edge_functions(mesh, triangle, ray_->cells->piece->reference), cells);
        if (masks.perhaps_inside == 0) return;
        bool hit = false;
        std::size_t sample = kTimeCells;  // whose depth it is
        PlaneDepth depth;
        for (std::uint32_t rest = masks.perhaps_inside; rest != 0; rest &= rest - 1) {
            const auto cell = static_cast<std::size_t>(std::countr_zero(rest));
            if (cell / ray_->cells->exposures.size() != sample) {
                sample = cell / ray_->cells->exposures.size();
                depth = PlaneDepth(mesh, triangle, *ray_->cells->piece, ray_->x[cell], ray_->y[cell]);
            }
            const bool whole = (masks.surely_inside >> cell & 1U) != 0;
            hit |= whole ? record_whole(triangle, depth, cell) : record_parts(triangle, depth, cell);
        }
        if (hit) ++counters_->triangle_hits;
    }

  private:
    void begin_at(const CellStarts& starts) {
        for (std::uint32_t rest = ray_->active; rest != 0; rest &= rest - 1) {
            const auto cell = static_cast<std::size_t>(std::countr_zero(rest));
            depths_.nearest[cell] = starts.nearest(cell);
        }
    }

    bool record_whole(TriangleId triangle, const PlaneDepth& depth, std::size_t cell) {
        if (sign_changes<2>(depth.numerator_in(*ray_->cells, cell)) != 0) return record_parts(triangle, depth, cell);
        return record(triangle, depth, cell, {0.0, 1.0});
    }

    bool record_parts(TriangleId triangle, const PlaneDepth& depth, std::size_t cell) {
        const LineInCell line = {sides_.in(cell), depth.numerator_in(*ray_->cells, cell)};
        bool hit = false;
        for (const Stretch& s : inside_stretches(line)) hit |= record(triangle, depth, cell, s);
        return hit;
    }

    bool record(TriangleId triangle, const PlaneDepth& depth, std::size_t cell, Stretch stretch) {
        if (ray_->starts == nullptr) return record_seen(triangle, depth, cell, stretch);
        bool hit = false;
        const Bernstein<2> numerator = depth.numerator_in(*ray_->cells, cell);
        const Bernstein<2> denominator = depth.denominator_in(*ray_->cells, cell);
        for (const Stretch& s : ray_->starts->before(numerator, denominator, cell, stretch)) {
            hit |= record_seen(triangle, depth, cell, s);
        }
        return hit;
    }

    bool record_seen(TriangleId triangle, const PlaneDepth& depth, std::size_t cell, Stretch stretch) {
        const auto [begin, end] = stretch;
        const double s0 = depth.at(ray_->cells->piece_u(cell, begin));
        const double s1 = depth.at(ray_->cells->piece_u(cell, 0.5 * (begin + end)));
        const double s2 = depth.at(ray_->cells->piece_u(cell, end));
        if (!(s1 > 0.0)) return false;
        // s is a smooth ratio of quadratics over a short time: its turns between the three are covered by their spread.
        const double low = std::min({s0, s1, s2});
        const double high = std::max({s0, s1, s2});
        const double margin = 0.5 * (high - low) + 1e-9 * high;
        if (low - margin > static_cast<double>(depths_.farthest[cell])) return true;
        (*records_)[cell].push_back({begin, end, low - margin, high + margin, triangle});
        hide_behind_records(cell);
        return true;
    }

    // Records in order of time; of those that begin together the nearer first.
    static bool goes_before(const CellRecord& a, const CellRecord& b) {
        return a.begin != b.begin ? a.begin < b.begin : a.farthest_m < b.farthest_m;
    }

    // Nothing behind records that together cover the cell can be seen.
    void hide_behind_records(std::size_t cell) {
        auto& list = (*records_)[cell];
        for (std::size_t i = list.size() - 1; i > 0 && goes_before(list[i], list[i - 1]); --i) {
            std::swap(list[i], list[i - 1]);
        }
        double reach = 0.0;
        double far = 0.0;
        for (const CellRecord& r : list) {
            if (r.begin > reach) return;
            if (r.end > reach) far = std::max(far, r.farthest_m);
            reach = std::max(reach, r.end);
        }
        if (reach < 1.0) return;
        depths_.end_at(cell, static_cast<float>(far * (1.0 + static_cast<double>(kWiden))));
    }

    const SweptRays* ray_;
    CellRecords* records_;
    TraceCounters* counters_;
    CellLines lines_;
    TriangleSides<4> sides_;
    LookedAt depths_;
};

void gather(const SweptRays& ray, CellRecords& records, TraceCounters& counters) {
    RecordWalk(ray, records, counters).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(gather);

SweptRays::SweptRays(const TriangleMesh& terrain, const StaticBvh& hierarchy, const TimeCells& time,
                     std::span<const ImageSample> samples)
    : mesh(&terrain), bvh(&hierarchy), cells(&time) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (std::size_t k = 0; k < time.exposures.size(); ++k) {
            const std::size_t cell = i * time.exposures.size() + k;
            x[cell] = samples[i].x;
            y[cell] = samples[i].y;
            active |= 1U << cell;
        }
    }
}

void gather_records(const SweptRays& rays, CellRecords& records, TraceCounters& counters) {
    HWY_DYNAMIC_DISPATCH(gather)(rays, records, counters);
}
}  // namespace overfly
#endif
