// How swept rays go through a hierarchy of boxes, whatever is done with the triangles there. For Highway: included once
// for each vector unit, by .cpp files that have included hwy/foreach_target.h and hwy/highway.h.
#if defined(OVERFLY_TRACE_BOX_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERFLY_TRACE_BOX_WALK_INL_H
#undef OVERFLY_TRACE_BOX_WALK_INL_H
#else
#define OVERFLY_TRACE_BOX_WALK_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "trace/static_bvh.h"
#include "trace/time_cells.h"
#include "trace/visible_segment.h"

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

// Rounds to float in the lanes from `first`. What that rounding moves is less than the widening before it.
template <class V>
HWY_INLINE void store_float(V v, float* to) {
    const hn::Rebind<float, Doubles> f;
    hn::Store(hn::DemoteTo(f, v), f, to);
}

// Bounds of the swept ray in each cell: of its origin, and of the reciprocal of its direction.
struct alignas(64) Sweep {
    std::array<PerCell<float>, 3> origin_low, origin_high;
    std::array<PerCell<float>, 3> inverse_low, inverse_high;  // 1 / low and 1 / high of the direction
    std::array<bool, 3> any_mixed{};                          // a direction of either sign in some cell
};

// Bounds of origins in every cell, relative to a reference.
struct OriginBounds {
    const std::array<PerCell<double>, 3>* low;
    const std::array<PerCell<double>, 3>* high;
    Point<Scene> reference;
};

inline void sweep_origins(const OriginBounds& origins, float slack_m, Sweep& sweep) {
    const Doubles d;
    const std::size_t lanes = hn::Lanes(d);
    const std::array<double, 3> reference = {origins.reference.x, origins.reference.y, origins.reference.z};
    const auto slack = static_cast<double>(slack_m);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t first = 0; first < kTimeCells; first += lanes) {
            const auto low = hn::Load(d, &(*origins.low)[axis][first]);
            const auto high = hn::Load(d, &(*origins.high)[axis][first]);
            store_float(hn::Add(low, hn::Set(d, reference[axis] - slack)), &sweep.origin_low[axis][first]);
            store_float(hn::Add(high, hn::Set(d, reference[axis] + slack)), &sweep.origin_high[axis][first]);
        }
    }
}

template <std::size_t kDegree>
void sweep_directions(const CellVectors<kDegree>& direction, Sweep& sweep) {
    const Doubles d;
    const std::size_t lanes = hn::Lanes(d);
    const auto zero = hn::Zero(d);
    const auto tiny = hn::Set(d, kTiny);
    const auto widen = hn::Set(d, static_cast<double>(kWiden));
    const auto one = hn::Set(d, 1.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t first = 0; first < kTimeCells; first += lanes) {
            auto low = hn::Load(d, &direction[axis][0][first]);
            auto high = low;
            for (std::size_t j = 1; j <= kDegree; ++j) {
                const auto coefficient = hn::Load(d, &direction[axis][j][first]);
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
        }
    }
}

// Between which depths the rays of each cell look for anything.
struct alignas(64) LookedAt {
    explicit LookedAt(std::uint32_t active_cells) : active(active_cells) {
        for (std::size_t cell = 0; cell < kTimeCells; ++cell) {
            farthest[cell] = (active >> cell & 1U) != 0 ? kInfinity : -kInfinity;
        }
    }

    // Nothing beyond is of interest.
    void end_at(std::size_t cell, float depth) {
        farthest[cell] = std::min(farthest[cell], depth);
        farthest_of_all = -kInfinity;
        for (std::uint32_t rest = active; rest != 0; rest &= rest - 1) {
            farthest_of_all = std::max(farthest_of_all, farthest[static_cast<std::size_t>(std::countr_zero(rest))]);
        }
    }

    PerCell<float> nearest{}, farthest;
    float farthest_of_all = kInfinity;
    std::uint32_t active;
};

// Calls visit(triangle, cells) for what is in the boxes that rays in these cells may meet, about from front to back.
// `visit` may shorten `depths` meanwhile.
template <class Visit>
class BoxWalk {
  public:
    BoxWalk(const StaticBvh& bvh, const Sweep& sweep, const LookedAt& depths, TraceCounters& counters, Visit& visit)
        : bvh_(&bvh), sweep_(&sweep), depths_(&depths), counters_(&counters), visit_(&visit) {}

    void run() {
        if (bvh_->empty() || depths_->active == 0) return;
        struct Entry {
            std::uint32_t node, cells;
            float enter;
        };
        std::array<Entry, kStack> stack;
        std::size_t height = 0;
        stack[height++] = {0, depths_->active, 0.0F};
        while (height > 0) {
            const Entry entry = stack[--height];
            if (entry.enter > depths_->farthest_of_all) continue;
            const StaticBvh::Node& node = bvh_->nodes[entry.node];
            const std::array<Hits, 2> hits = {box_hits(node, 0, entry.cells), box_hits(node, 1, entry.cells)};
            // The nearer child first, so that what it covers can hide the other.
            const std::size_t near = hits[1].enter < hits[0].enter ? 1 : 0;
            std::array<Entry, 2> inner;
            std::size_t inner_count = 0;
            for (const std::size_t k : {near, 1 - near}) {
                if (hits[k].cells == 0) continue;
                if (node.size[k] > 0) {
                    for (std::uint32_t i = 0; i < node.size[k]; ++i) {
                        (*visit_)(bvh_->triangles[node.child[k] + i], hits[k].cells);
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

    // Which cells meet a box, and how near at least.
    struct Hits {
        std::uint32_t cells = 0;
        float enter = kInfinity;
    };

    // The slab test of Kay and Kajiya 1986 in interval arithmetic: the earliest entry and the latest exit of any ray
    // that starts in the origin's bounds and runs along a direction within its bounds.
    HWY_INLINE Hits box_hits(const StaticBvh::Node& node, std::size_t child, std::uint32_t cells) {
        ++counters_->box_tests;
        const Floats d;
        const std::size_t lanes = hn::Lanes(d);
        Hits hits;
        for (std::size_t first = 0; first < kTimeCells; first += lanes) {
            auto enter = hn::Load(d, &depths_->nearest[first]);
            auto exit = hn::Load(d, &depths_->farthest[first]);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const auto from_low =
                    hn::Sub(hn::Set(d, node.low[child][axis]), hn::Load(d, &sweep_->origin_high[axis][first]));
                const auto to_high =
                    hn::Sub(hn::Set(d, node.high[child][axis]), hn::Load(d, &sweep_->origin_low[axis][first]));
                const auto inverse_low = hn::Load(d, &sweep_->inverse_low[axis][first]);
                const auto inverse_high = hn::Load(d, &sweep_->inverse_high[axis][first]);
                const auto a = hn::Mul(from_low, inverse_low);
                const auto b = hn::Mul(from_low, inverse_high);
                const auto c = hn::Mul(to_high, inverse_low);
                const auto e = hn::Mul(to_high, inverse_high);
                auto axis_enter = hn::Min(hn::Min(a, b), hn::Min(c, e));
                auto axis_exit = hn::Max(hn::Max(a, b), hn::Max(c, e));
                if (sweep_->any_mixed[axis]) {
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

    const StaticBvh* bvh_;
    const Sweep* sweep_;
    const LookedAt* depths_;
    TraceCounters* counters_;
    Visit* visit_;
};

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#endif
