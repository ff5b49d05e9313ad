// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/kinetic_stride.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>

#include "trace/kinetic_lanes-inl.h"
#include "trace/kinetic_stride.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace kinetic_stride {  // a Walk of its own: swept_ray.cpp has another

// An edge function is in doubt by this much of the distance times the extent of the triangle beside the line: two to
// three roundings (2^-24) of it. Assumed, not derived: held by the agreement with double. Less of it sends more samples
// to the careful steps, more of it lets a line pass a corner on the wrong side.
constexpr float kDoubt = 1.5e-7F;

// What a step ahead may leave out, relative to the distance: some thousandths of a pixel.
constexpr float kUntold = 4e-6F;
constexpr int kMostHalvings = 10;

// Steps without progress, as around a vertex, after which a lane gives up.
constexpr std::int32_t kMostStalled = 24;

class Walk {
  public:
    Walk(const StrideTask& task, StrideLog& log)
        : scene_(&task.scene),
          samples_(task.samples),
          who_(task.who),
          enough_(static_cast<float>(task.enough_u)),
          log_(&log),
          twins_(reinterpret_cast<const std::int32_t*>(task.scene.mesh->twins.data())),
          apexes_(reinterpret_cast<const std::int32_t*>(task.scene.across->apexes.data())),
          places_(task.scene.positions.front().data()),
          front_(reinterpret_cast<const std::int32_t*>(task.scene.front.data())) {}

    void run() {
        std::uint32_t active = 0;
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            take_up(lane, who_[next_ < who_.size() ? next_ : 0]);
            if (next_ < who_.size()) active |= 1U << lane;
            ++next_;
        }
        next_ = std::min(next_, who_.size());
        const std::size_t lanes = hn::Lanes(Floats());
        const std::uint32_t chunk = (1U << lanes) - 1U;
        while (active != 0) {
            for (std::size_t first = 0; first < kLanes; first += lanes) {
                if ((active >> first & chunk) == 0) continue;
                log_->reserve_more(lanes);
                const Stops stops = step(first);
                for (std::uint32_t rest = (stops.at_limit | stops.in_doubt) & active; rest != 0; rest &= rest - 1) {
                    const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
                    put_down(lane, (stops.in_doubt >> lane & 1U) != 0);
                    if (next_ < who_.size()) {
                        take_up(lane, who_[next_++]);
                    } else {
                        active &= ~(1U << lane);
                    }
                }
            }
        }
    }

  private:
    struct Stops {
        std::uint32_t at_limit = 0, in_doubt = 0;  // a bit for each lane
    };

    void take_up(std::size_t lane, std::uint32_t who) {
        const Stride& s = samples_[who];
        w_.u[lane] = w_.since[lane] = static_cast<float>(s.u);
        w_.limit[lane] = static_cast<float>(s.limit_u);
        w_.triangle[lane] = w_.seen[lane] = static_cast<std::int32_t>(s.triangle);
        w_.side[lane] = w_.arrives[lane] = w_.stalled[lane] = w_.moved[lane] = 0;
        w_.who[lane] = static_cast<std::int32_t>(who);
        w_.last[lane] = static_cast<std::int32_t>(s.last);
        const auto& corner = scene_->mesh->triangles[s.triangle];
        const auto x = static_cast<float>(s.x);
        const auto y = static_cast<float>(s.y);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            w_.p[axis][lane] = scene_->positions[corner[0]][axis];
            w_.q[axis][lane] = scene_->positions[corner[1]][axis];
            w_.r[axis][lane] = scene_->positions[corner[2]][axis];
            for (std::size_t power = 0; power < 3; ++power) {
                w_.line[power][axis][lane] =
                    x * scene_->right[power][axis] + y * scene_->down[power][axis] + scene_->view[power][axis];
            }
        }
    }

    void put_down(std::size_t lane, bool doubt) {
        Stride& s = samples_[static_cast<std::size_t>(w_.who[lane])];
        s.stop_u = static_cast<double>(w_.u[lane]);
        s.stop = doubt ? Stride::Stop::Doubt : Stride::Stop::Limit;
        s.triangle = static_cast<TriangleId>(w_.seen[lane]);
        s.has_moved = w_.moved[lane] != 0;
        s.last = static_cast<RecordId>(w_.last[lane]);
        if (s.has_moved) s.u = static_cast<double>(w_.since[lane]);
    }

    // Where the camera is, which way the line runs, and how both change.
    struct Look {
        Vec3 origin, line, d_line, dd_line;  // line at u + h: line + d_line h + dd_line h^2
        // What the camera's own motion adds to the speed and to half the acceleration of a corner beside the line.
        V carry_x, carry_y, d_carry_x, d_carry_y;
        HWY_INLINE Beside beside(const Vec3& corner) const {
            const V wx = hn::Sub(corner.x, origin.x);
            const V wy = hn::Sub(corner.y, origin.y);
            const V wz = hn::Sub(corner.z, origin.z);
            return {hn::Sub(mul(wz, line.y), mul(wy, line.z)),
                    hn::Sub(mul(wz, line.x), mul(wx, line.z)),
                    hn::Add(hn::Sub(mul(wz, d_line.y), mul(wy, d_line.z)), carry_x),
                    hn::Add(hn::Sub(mul(wz, d_line.x), mul(wx, d_line.z)), carry_y),
                    hn::Add(hn::Sub(mul(wz, dd_line.y), mul(wy, dd_line.z)), d_carry_x),
                    hn::Add(hn::Sub(mul(wz, dd_line.x), mul(wx, dd_line.z)), d_carry_y)};
        }
        HWY_INLINE V reach(const Vec3& corner) const {
            return hn::Add(hn::Add(hn::Abs(hn::Sub(corner.x, origin.x)), hn::Abs(hn::Sub(corner.y, origin.y))),
                           hn::Abs(hn::Sub(corner.z, origin.z)));
        }
    };

    HWY_INLINE V origin_at(std::size_t axis, V u) const {
        const Floats d;
        const auto& c = scene_->origin;
        return hn::Add(hn::Set(d, c[0][axis]), mul(u, hn::Add(hn::Set(d, c[1][axis]), mul(u, hn::Set(d, c[2][axis])))));
    }
    HWY_INLINE V d_origin_at(std::size_t axis, V u) const {
        const Floats d;
        const auto& c = scene_->origin;
        return hn::Add(hn::Set(d, c[1][axis]), mul(u, hn::Set(d, 2.0F * c[2][axis])));
    }
    HWY_INLINE V line_at(std::size_t axis, V u, std::size_t first) const {
        return hn::Add(load(w_.line[0][axis], first),
                       mul(u, hn::Add(load(w_.line[1][axis], first), mul(u, load(w_.line[2][axis], first)))));
    }
    HWY_INLINE V d_line_at(std::size_t axis, V u, std::size_t first) const {
        return hn::Add(load(w_.line[1][axis], first), mul(hn::Add(u, u), load(w_.line[2][axis], first)));
    }
    HWY_INLINE Look look_at(V u, std::size_t first) const {
        Look look;
        look.origin = {origin_at(0, u), origin_at(1, u), origin_at(2, u)};
        look.line = {line_at(0, u, first), line_at(1, u, first), line_at(2, u, first)};
        look.d_line = {d_line_at(0, u, first), d_line_at(1, u, first), d_line_at(2, u, first)};
        look.dd_line = {load(w_.line[2][0], first), load(w_.line[2][1], first), load(w_.line[2][2], first)};
        const V vx = d_origin_at(0, u);
        const V vy = d_origin_at(1, u);
        const V vz = d_origin_at(2, u);
        const Floats d;
        const auto& a = scene_->origin[2];
        const V az = hn::Set(d, a[2]);
        look.carry_x = hn::Sub(mul(vy, look.line.z), mul(vz, look.line.y));
        look.carry_y = hn::Sub(mul(vx, look.line.z), mul(vz, look.line.x));
        look.d_carry_x = hn::Add(hn::Sub(mul(vy, look.d_line.z), mul(vz, look.d_line.y)),
                                 hn::Sub(mul(hn::Set(d, a[1]), look.line.z), mul(az, look.line.y)));
        look.d_carry_y = hn::Add(hn::Sub(mul(vx, look.d_line.z), mul(vz, look.d_line.x)),
                                 hn::Sub(mul(hn::Set(d, a[0]), look.line.z), mul(az, look.line.x)));
        return look;
    }

    HWY_INLINE Stops step(std::size_t first) {
        const Floats d;
        const V zero = hn::Zero(d);
        const V u = load(w_.u, first);
        const V limit = load(w_.limit, first);
        const V since = load(w_.since, first);
        const Vec3 p = load3(w_.p, first);
        const Vec3 q = load3(w_.q, first);
        const Vec3 r = load3(w_.r, first);
        const Look look = look_at(u, first);
        const Beside bp = look.beside(p);
        const Beside bq = look.beside(q);
        const Beside br = look.beside(r);
        const std::array<EdgeTerms, 3> edge = {edge_terms(bp, bq), edge_terms(bq, br), edge_terms(br, bp)};
        const V reach = hn::Max(look.reach(p), hn::Max(look.reach(q), look.reach(r)));
        const V doubt = mul(mul(hn::Set(d, kDoubt), reach), hn::Add(hn::Add(extent(bp), extent(bq)), extent(br)));

        // It has come through p-q at about u: when exactly, by Newton's method.
        const M arrives = as_mask(load(w_.arrives, first));
        const M comes_in = hn::Gt(edge[0].slope, zero);
        const V back = hn::Div(edge[0].value, hn::IfThenElse(comes_in, edge[0].slope, hn::Set(d, 1.0F)));
        const V shift = hn::IfThenElse(hn::And(arrives, comes_in), hn::Neg(back), zero);
        const M astray = hn::And(arrives, hn::And(hn::Not(comes_in), hn::Gt(hn::Abs(edge[0].value), doubt)));
        const M again = hn::And(hn::Not(astray), hn::Gt(mul(hn::Abs(edge[0].bend), mul(shift, shift)), doubt));
        const V at = hn::Min(hn::Max(hn::Add(u, shift), since), limit);

        // Is it inside?
        const V low = hn::Neg(doubt);
        const V value1 = hn::Add(edge[1].value, mul(edge[1].slope, shift));
        const V value2 = hn::Add(edge[2].value, mul(edge[2].slope, shift));
        const M beyond_side = hn::Or(arrives, hn::Ge(edge[0].value, low));
        const M inside = hn::And(beyond_side, hn::And(hn::Ge(value1, low), hn::Ge(value2, low)));
        const M settled = hn::AndNot(hn::Or(again, astray), inside);
        const I stalled = count_stalled(hn::And(hn::And(arrives, settled), hn::Gt(at, since)), first);
        const M stuck = hn::RebindMask(d, hn::Gt(stalled, hn::Set(Ints(), kMostStalled)));
        M in_doubt = hn::Or(stuck, hn::And(hn::Not(again), hn::Not(settled)));

        const M enters = hn::AndNot(in_doubt, hn::And(arrives, settled));
        log_entries(enters, at, first);
        const V now_since = hn::IfThenElse(enters, at, since);
        store(now_since, w_.since, first);

        const M walks = hn::AndNot(in_doubt, settled);
        const M repeats = hn::AndNot(in_doubt, again);
        store(hn::IfThenElse(repeats, at, u), w_.u, first);
        const Left left = leave(walks, edge, {p, q, r}, reach, first);
        return {bits_of(left.to_limit, first), bits_of(hn::Or(in_doubt, left.cares), first)};
    }

    HWY_INLINE I count_stalled(M progress, std::size_t first) {
        const I count = hn::IfThenElse(hn::RebindMask(Ints(), progress), hn::Zero(Ints()),
                                       hn::Add(load(w_.stalled, first), hn::Set(Ints(), 1)));
        store(count, w_.stalled, first);
        return count;
    }

    // A record for every lane, but only those that enter know of theirs.
    HWY_INLINE void log_entries(M enters, V at, std::size_t first) {
        const Floats d;
        const Ints di;
        const I seen = load(w_.seen, first);
        const I last = load(w_.last, first);
        hn::StoreU(seen, di, reinterpret_cast<std::int32_t*>(&log_->triangle[log_->count]));
        hn::StoreU(last, di, reinterpret_cast<std::int32_t*>(&log_->before[log_->count]));
        hn::StoreU(at, d, &log_->until_u[log_->count]);
        const auto enters_i = hn::RebindMask(di, enters);
        const I record = hn::Iota(di, static_cast<std::int32_t>(log_->count));
        log_->count += hn::Lanes(d);
        store(hn::IfThenElse(enters_i, record, last), w_.last, first);
        store(hn::IfThenElse(enters_i, load(w_.triangle, first), seen), w_.seen, first);
        store(hn::Or(load(w_.moved, first), as_ints(enters)), w_.moved, first);
    }

    // What lanes come to that do not walk on: their limit, or a neighbour that asks for more care.
    struct Left {
        M to_limit, cares;
    };

    // As much of a time ahead as the terms of third order, which nobody looks at, leave certain.
    HWY_INLINE V told(V h, V reach) const {
        const Floats d;
        const V most = mul(reach, hn::Set(d, kUntold / scene_->third_order_m));
        for (int halving = 0; halving < kMostHalvings; ++halving) {
            const M too_far = hn::Gt(mul(mul(h, h), h), most);
            if (hn::AllFalse(d, too_far)) break;
            h = hn::IfThenElse(too_far, mul(h, hn::Set(d, 0.5F)), h);
        }
        return h;
    }

    // To the neighbour across the side that is passed first, or to the limit.
    HWY_INLINE Left leave(M walks, const std::array<EdgeTerms, 3>& edge, const std::array<Vec3, 3>& corner, V reach,
                          std::size_t first) {
        const Floats d;
        const Ints di;
        const Fraction exit1 = time_to_exit(edge[1]);
        const Fraction exit2 = time_to_exit(edge[2]);
        const Fraction exit0 = time_to_exit(edge[0]);
        const M sooner2 = is_sooner(exit2, exit1);
        const Fraction exit12 = select(sooner2, exit2, exit1);
        const M sooner0 = is_sooner(exit0, exit12);
        const Fraction exit = select(sooner0, exit0, exit12);
        const M by2 = hn::AndNot(sooner0, sooner2);
        const M by1 = hn::Not(hn::Or(sooner0, sooner2));
        const V h = hn::Max(hn::Div(exit.numerator, exit.denominator), hn::Zero(d));
        const V u = load(w_.u, first);
        const V limit = load(w_.limit, first);
        const V wish = hn::Min(h, hn::Sub(limit, u));
        const V step = told(wish, reach);
        const V at = hn::Max(hn::Add(u, step), load(w_.since, first));
        const M pauses_at = hn::And(walks, hn::Lt(step, wish));
        const M comes_to_limit = hn::AndNot(pauses_at, hn::And(walks, hn::Ge(hn::Max(hn::Add(u, h), at), limit)));
        const M to_limit = hn::Or(comes_to_limit, hn::And(walks, hn::Ge(at, hn::Set(d, enough_))));
        const M pauses = hn::AndNot(to_limit, pauses_at);
        const M crosses = hn::AndNot(hn::Or(to_limit, pauses), walks);

        const I triangle = load(w_.triangle, first);
        const I local = hn::IfThenElse(hn::RebindMask(di, by1), hn::Set(di, 1),
                                       hn::IfThenElse(hn::RebindMask(di, by2), hn::Set(di, 2), hn::Zero(di)));
        const I side = modulo3(hn::Add(load(w_.side, first), local));
        const I row = hn::Add(triangle, hn::Add(triangle, triangle));
        const I entry = hn::Add(row, side);
        const I twin = hn::GatherIndex(di, twins_, entry);
        const I apex = hn::GatherIndex(di, apexes_, entry);
        const M border = as_mask(twin);
        const I next = hn::IfThenElseZero(hn::RebindMask(di, hn::Not(border)), hn::ShiftRight<2>(twin));
        const I next_side = hn::And(twin, hn::Set(di, 3));
        const M cares = hn::And(crosses, hn::Or(border, hn::Not(is_front(next))));
        const M goes = hn::AndNot(cares, crosses);

        const I place = hn::ShiftLeft<2>(apex);
        const Vec3 r = {hn::GatherIndex(d, places_, place), hn::GatherIndex(d, places_ + 1, place),
                        hn::GatherIndex(d, places_ + 2, place)};
        // The neighbour runs along the shared side the other way.
        const auto& [cp, cq, cr] = corner;
        store3(select(goes, select(by1, cr, select(by2, cp, cq)), cp), w_.p, first);
        store3(select(goes, select(by1, cq, select(by2, cr, cp)), cq), w_.q, first);
        store3(select(goes, r, cr), w_.r, first);
        const auto goes_i = hn::RebindMask(di, goes);
        store(hn::IfThenElse(goes_i, next, triangle), w_.triangle, first);
        store(hn::IfThenElse(goes_i, next_side, load(w_.side, first)), w_.side, first);
        const I kept = hn::AndNot(as_ints(walks), load(w_.arrives, first));
        store(hn::Or(kept, as_ints(goes)), w_.arrives, first);
        store(hn::IfThenElse(hn::Or(crosses, pauses), at, u), w_.u, first);
        return {to_limit, cares};
    }

    HWY_INLINE I modulo3(I i) const {
        const Ints di;
        const I three = hn::Set(di, 3);
        return hn::IfThenElse(hn::Lt(i, three), i, hn::Sub(i, three));
    }

    HWY_INLINE M is_front(I triangle) const {
        const Ints di;
        const I word = hn::GatherIndex(di, front_, hn::ShiftRight<5>(triangle));
        const I bit = hn::Shl(hn::Set(di, 1), hn::And(triangle, hn::Set(di, 31)));
        return hn::RebindMask(Floats(), hn::Ne(hn::And(word, bit), hn::Zero(di)));
    }

    const StrideScene* scene_;
    std::span<Stride> samples_;
    std::span<const std::uint32_t> who_;
    float enough_;
    StrideLog* log_;
    const std::int32_t *twins_, *apexes_;  // three for each triangle
    const float* places_;
    const std::int32_t* front_;
    std::size_t next_ = 0;
    Walkers w_{};
};

}  // namespace kinetic_stride

void walk_strides(const StrideTask& task, StrideLog& log) { kinetic_stride::Walk(task, log).run(); }

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(walk_strides);

void stride(const StrideTask& task, StrideLog& log) {
    if (task.who.empty()) return;
    HWY_DYNAMIC_DISPATCH(walk_strides)(task, log);
}
}  // namespace overfly
#endif
