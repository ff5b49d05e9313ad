// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/swept_ray.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "trace/inside_stretches.h"
#include "trace/line.h"
#include "trace/plane_depth.h"
#include "trace/swept_ray.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, kTimeCells>;
using Doubles = hn::CappedTag<double, kTimeCells>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Box tests are in float and only have to err on the side of a hit: the places are widened by StaticBvh::slack_m and
// the directions and depths by more than the few roundings between them.
constexpr float kWiden = 1e-6F;
// A direction component nearer to zero than this is treated as either sign.
constexpr double kTiny = 1e-20;

// Appends the bits of a mask of lanes that begin at cell `first`.
template <class D>
HWY_INLINE std::uint32_t bits_at(D d, hn::Mask<D> mask, std::size_t first) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, mask, bytes);
    return (static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U) << first;
}

// Bounds of the swept ray in each cell: of its origin, and of the reciprocal of its direction.
struct alignas(64) Sweep {
    std::array<PerCell<float>, 3> origin_low, origin_high;
    std::array<PerCell<float>, 3> inverse_low, inverse_high;  // 1 / low and 1 / high of the direction
    std::array<bool, 3> any_mixed{};                          // a direction of either sign in some cell
};

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

// Rounds to float in the lanes from `first`. What that rounding moves is less than the widening before it.
template <class V>
HWY_INLINE void store_float(V v, float* to) {
    const hn::Rebind<float, Doubles> f;
    hn::Store(hn::DemoteTo(f, v), f, to);
}

Sweep sweep_of(const SweptRays& ray, const CellLines& lines) {
    Sweep sweep;
    const Doubles d;
    const std::size_t lanes = hn::Lanes(d);
    const Point<Scene> at = ray.cells->piece->reference;
    const std::array<double, 3> reference = {at.x, at.y, at.z};
    const auto slack = static_cast<double>(ray.bvh->slack_m);
    const auto zero = hn::Zero(d);
    const auto tiny = hn::Set(d, kTiny);
    const auto widen = hn::Set(d, static_cast<double>(kWiden));
    const auto one = hn::Set(d, 1.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t first = 0; first < kTimeCells; first += lanes) {
            auto low = hn::Load(d, &lines.direction[axis][0][first]);
            auto high = low;
            for (std::size_t j = 1; j < 5; ++j) {
                const auto coefficient = hn::Load(d, &lines.direction[axis][j][first]);
                low = hn::Min(low, coefficient);
                high = hn::Max(high, coefficient);
            }
            low = hn::Sub(hn::Sub(low, hn::Mul(widen, hn::Abs(low))), tiny);
            high = hn::Add(hn::Add(high, hn::Mul(widen, hn::Abs(high))), tiny);
            // Zero as a bound would divide by zero; a bound this small on either side is as good.
            low = hn::IfThenElse(hn::Eq(low, zero), hn::Neg(tiny), low);
            high = hn::IfThenElse(hn::Eq(high, zero), tiny, high);
            store_float(hn::Div(one, low), &sweep.inverse_low[axis][first]);
            store_float(hn::Div(one, high), &sweep.inverse_high[axis][first]);
            const auto mixed = hn::And(hn::Lt(low, zero), hn::Gt(high, zero));
            sweep.any_mixed[axis] = sweep.any_mixed[axis] || !hn::AllFalse(d, mixed);
            const auto low_origin = hn::Load(d, &ray.cells->origin_low[axis][first]);
            const auto high_origin = hn::Load(d, &ray.cells->origin_high[axis][first]);
            store_float(hn::Add(low_origin, hn::Set(d, reference[axis] - slack)), &sweep.origin_low[axis][first]);
            store_float(hn::Add(high_origin, hn::Set(d, reference[axis] + slack)), &sweep.origin_high[axis][first]);
        }
    }
    return sweep;
}

// Which cells meet a box, and how near at least.
struct BoxHits {
    std::uint32_t cells = 0;
    float enter = kInfinity;
};

class Walk {
  public:
    Walk(const SweptRays& ray, CellRecords& records, TraceCounters& counters)
        : ray_(&ray), records_(&records), counters_(&counters), lines_(lines_of(ray)), sweep_(sweep_of(ray, lines_)) {
        far_.fill(kInfinity);
    }

    void run() {
        if (ray_->bvh->empty() || ray_->active == 0) return;
        struct Entry {
            std::uint32_t node, cells;
            float enter;
        };
        std::array<Entry, kStack> stack;
        std::size_t height = 0;
        stack[height++] = {0, ray_->active, 0.0F};
        while (height > 0) {
            const Entry entry = stack[--height];
            if (entry.enter > farthest_) continue;
            const StaticBvh::Node& node = ray_->bvh->nodes[entry.node];
            const std::array<BoxHits, 2> hits = {box_hits(node, 0, entry.cells), box_hits(node, 1, entry.cells)};
            // The nearer child first, so that what it covers can hide the other.
            const std::size_t near = hits[1].enter < hits[0].enter ? 1 : 0;
            std::array<Entry, 2> inner;
            std::size_t inner_count = 0;
            for (const std::size_t k : {near, 1 - near}) {
                if (hits[k].cells == 0) continue;
                if (node.size[k] > 0) {
                    for (std::uint32_t i = 0; i < node.size[k]; ++i) {
                        test_triangle(ray_->bvh->triangles[node.child[k] + i], hits[k].cells);
                    }
                } else {
                    inner[inner_count++] = {node.child[k], hits[k].cells, hits[k].enter};
                }
            }
            while (inner_count > 0) stack[height++] = inner[--inner_count];
        }
    }

  private:
    static constexpr std::size_t kStack = 128;  // twice the deepest hierarchy that build_static_bvh makes

    // The slab test of Kay and Kajiya 1986 in interval arithmetic: the earliest entry and the latest exit of any ray
    // that starts in the origin's bounds and runs along a direction within its bounds.
    HWY_INLINE BoxHits box_hits(const StaticBvh::Node& node, std::size_t child, std::uint32_t cells) {
        ++counters_->box_tests;
        const Floats d;
        const std::size_t lanes = hn::Lanes(d);
        BoxHits hits;
        for (std::size_t first = 0; first < kTimeCells; first += lanes) {
            auto enter = hn::Zero(d);
            auto exit = hn::Load(d, &far_[first]);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto from_low =
                    hn::Sub(hn::Set(d, node.low[child][axis]), hn::Load(d, &sweep_.origin_high[axis][first]));
                const auto to_high =
                    hn::Sub(hn::Set(d, node.high[child][axis]), hn::Load(d, &sweep_.origin_low[axis][first]));
                const auto inverse_low = hn::Load(d, &sweep_.inverse_low[axis][first]);
                const auto inverse_high = hn::Load(d, &sweep_.inverse_high[axis][first]);
                const auto a = hn::Mul(from_low, inverse_low);
                const auto b = hn::Mul(from_low, inverse_high);
                const auto c = hn::Mul(to_high, inverse_low);
                const auto e = hn::Mul(to_high, inverse_high);
                auto axis_enter = hn::Min(hn::Min(a, b), hn::Min(c, e));
                auto axis_exit = hn::Max(hn::Max(a, b), hn::Max(c, e));
                if (sweep_.any_mixed[axis]) {
                    // A direction of either sign never has to leave, and reaches the slab from outside no sooner than
                    // this.
                    const auto mixed = hn::And(hn::Lt(inverse_low, hn::Zero(d)), hn::Gt(inverse_high, hn::Zero(d)));
                    axis_enter = hn::IfThenElse(mixed, hn::Max(b, c), axis_enter);
                    axis_exit = hn::IfThenElse(mixed, hn::Set(d, kInfinity), axis_exit);
                }
                enter = hn::Max(enter, axis_enter);
                exit = hn::Min(exit, axis_exit);
            }
            const auto met =
                hn::Le(hn::Mul(enter, hn::Set(d, 1.0F - kWiden)), hn::Mul(exit, hn::Set(d, 1.0F + kWiden)));
            const std::uint32_t chunk = bits_at(d, met, first) & cells;
            if (chunk == 0) continue;
            hits.cells |= chunk;
            const auto nearest = hn::MinOfLanes(d, hn::IfThenElse(met, enter, hn::Set(d, kInfinity)));
            hits.enter = std::min(hits.enter, hn::GetLane(nearest));
        }
        if (hits.cells != 0) ++counters_->box_hits;
        return hits;
    }

    // The cells in which a line passes the three sides on one hand, for certain or perhaps.
    struct SideMasks {
        std::uint32_t surely_inside = 0, perhaps_inside = 0;
    };

    HWY_INLINE SideMasks side_masks(std::uint32_t cells) {
        const Doubles d;
        const std::size_t lanes = hn::Lanes(d);
        const std::uint32_t chunk = (1U << lanes) - 1U;
        SideMasks masks;
        for (std::size_t first = 0; first < kTimeCells; first += lanes) {
            if ((cells >> first & chunk) == 0) continue;
            const auto zero = hn::Zero(d);
            auto all_front = hn::Eq(zero, zero);
            auto all_back = all_front;
            auto any_front = all_front;
            auto any_back = all_front;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [least, most] = edge_range(k, first);
                all_front = hn::And(all_front, hn::Ge(least, zero));
                all_back = hn::And(all_back, hn::Le(most, zero));
                any_front = hn::And(any_front, hn::Ge(most, zero));
                any_back = hn::And(any_back, hn::Le(least, zero));
            }
            masks.surely_inside |= bits_at(d, hn::Or(all_front, all_back), first);
            masks.perhaps_inside |= bits_at(d, hn::Or(any_front, any_back), first);
        }
        masks.surely_inside &= cells;
        masks.perhaps_inside &= cells;
        return masks;
    }

    // Evaluates the coefficients of edge k in the lanes from `first`, keeps them, and returns their range.
    HWY_INLINE std::pair<hn::Vec<Doubles>, hn::Vec<Doubles>> edge_range(std::size_t k, std::size_t first) {
        const Doubles d;
        const EdgeFunction& edge = edges_[k];
        // The order of operations is that of EdgeFunction::at, without fused steps, so that neighbours agree bit by
        // bit.
        const auto ax = hn::Set(d, -edge.sign * edge.a_cross_b.x);
        const auto ay = hn::Set(d, -edge.sign * edge.a_cross_b.y);
        const auto az = hn::Set(d, -edge.sign * edge.a_cross_b.z);
        const auto bx = hn::Set(d, -edge.sign * edge.b_minus_a.x);
        const auto by = hn::Set(d, -edge.sign * edge.b_minus_a.y);
        const auto bz = hn::Set(d, -edge.sign * edge.b_minus_a.z);
        auto least = hn::Set(d, std::numeric_limits<double>::infinity());
        auto most = hn::Neg(least);
        for (std::size_t j = 0; j < 5; ++j) {
            const auto term = [&](hn::Vec<Doubles> factor, const PerCell<double>& line)
                                  HWY_ATTR { return hn::Mul(factor, hn::Load(d, &line[first])); };
            const auto along = hn::Add(hn::Add(term(ax, lines_.direction[0][j]), term(ay, lines_.direction[1][j])),
                                       term(az, lines_.direction[2][j]));
            const auto about = hn::Add(hn::Add(term(bx, lines_.moment[0][j]), term(by, lines_.moment[1][j])),
                                       term(bz, lines_.moment[2][j]));
            const auto coefficient = hn::Add(along, about);
            hn::Store(coefficient, d, &coefficients_[k][j][first]);
            least = hn::Min(least, coefficient);
            most = hn::Max(most, coefficient);
        }
        return {least, most};
    }

    void test_triangle(TriangleId triangle, std::uint32_t cells) {
        ++counters_->triangle_tests;
        const TriangleMesh& mesh = *ray_->mesh;
        const Point<Scene> reference = ray_->cells->piece->reference;
        const auto& corner = mesh.triangles[triangle];
        for (std::size_t k = 0; k < 3; ++k) {
            const VertexId a = corner[k];
            const VertexId b = corner[(k + 1) % 3];
            edges_[k] = edge_function(a, b, mesh.positions[a] - reference, mesh.positions[b] - reference);
        }
        const SideMasks masks = side_masks(cells);
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

    bool record_whole(TriangleId triangle, const PlaneDepth& depth, std::size_t cell) {
        if (sign_changes<2>(depth.numerator_in(*ray_->cells, cell)) != 0) return record_parts(triangle, depth, cell);
        return record(triangle, depth, cell, 0.0, 1.0);
    }

    bool record_parts(TriangleId triangle, const PlaneDepth& depth, std::size_t cell) {
        LineInCell line;
        for (std::size_t k = 0; k < 3; ++k) {
            for (std::size_t j = 0; j < 5; ++j) line.side[k][j] = coefficients_[k][j][cell];
        }
        line.depth_numerator = depth.numerator_in(*ray_->cells, cell);
        bool hit = false;
        for (const Stretch& s : inside_stretches(line)) hit |= record(triangle, depth, cell, s.begin, s.end);
        return hit;
    }

    bool record(TriangleId triangle, const PlaneDepth& depth, std::size_t cell, double begin, double end) {
        const double s0 = depth.at(ray_->cells->piece_u(cell, begin));
        const double s1 = depth.at(ray_->cells->piece_u(cell, 0.5 * (begin + end)));
        const double s2 = depth.at(ray_->cells->piece_u(cell, end));
        if (!(s1 > 0.0)) return false;
        // s is a smooth ratio of quadratics over a short time: its turns between the three are covered by their spread.
        const double low = std::min({s0, s1, s2});
        const double high = std::max({s0, s1, s2});
        const double margin = 0.5 * (high - low) + 1e-9 * high;
        if (low - margin > static_cast<double>(far_[cell])) return true;
        (*records_)[cell].push_back({begin, end, low - margin, high + margin, triangle});
        update_far(cell);
        return true;
    }

    // Records in order of time; of those that begin together the nearer first.
    static bool goes_before(const CellRecord& a, const CellRecord& b) {
        return a.begin != b.begin ? a.begin < b.begin : a.farthest_m < b.farthest_m;
    }

    // Nothing behind records that together cover the cell can be seen.
    void update_far(std::size_t cell) {
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
        far_[cell] = std::min(far_[cell], static_cast<float>(far * (1.0 + static_cast<double>(kWiden))));
        farthest_ = 0.0F;
        for (std::uint32_t rest = ray_->active; rest != 0; rest &= rest - 1) {
            farthest_ = std::max(farthest_, far_[static_cast<std::size_t>(std::countr_zero(rest))]);
        }
    }

    const SweptRays* ray_;
    CellRecords* records_;
    TraceCounters* counters_;
    CellLines lines_;
    Sweep sweep_;
    alignas(64) PerCell<float> far_;
    float farthest_ = kInfinity;
    std::array<EdgeFunction, 3> edges_{};
    alignas(64) std::array<std::array<PerCell<double>, 5>, 3> coefficients_{};
};

void gather(const SweptRays& ray, CellRecords& records, TraceCounters& counters) { Walk(ray, records, counters).run(); }

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
