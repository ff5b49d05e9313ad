// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/ground_nodes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "shade/ground_nodes.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace ground_nodes {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Floats>;
using V = hn::Vec<Floats>;
using I = hn::Vec<Ints>;

constexpr float kFarthest_m = 1e10F;  // where rounding would else have it at infinity

HWY_INLINE V set(float x) { return hn::Set(Floats(), x); }
HWY_INLINE I set(std::int32_t x) { return hn::Set(Ints(), x); }
HWY_INLINE V of_runs(const GroundRuns::Lane<float>& lane, I run) { return hn::GatherIndex(Floats(), lane.data(), run); }
HWY_INLINE I of_runs(const GroundRuns::Lane<std::int32_t>& lane, I run) {
    return hn::GatherIndex(Ints(), lane.data(), run);
}
// What is no number becomes the least.
HWY_INLINE V between(V least, V x, V most) { return hn::IfThenElse(hn::Gt(x, least), hn::Min(x, most), least); }
HWY_INLINE V at(const GroundRuns::Quadratic& q, I run, V v) {
    const V rise = hn::Add(of_runs(q.c[1], run), hn::Mul(v, of_runs(q.c[2], run)));
    return hn::Add(of_runs(q.c[0], run), hn::Mul(v, rise));
}
HWY_INLINE V at(const GroundRuns::Linear& l, I run, V v) {
    return hn::Add(of_runs(l.from, run), hn::Mul(v, of_runs(l.more, run)));
}

// A place on one axis of the raster: after which sample, and how far from it to the next. Places outside are moved to
// the edge.
struct Between {
    I first;
    V share;
};
HWY_INLINE Between samples_beside(I corner, V from_corner, int count) {
    const V floor = hn::Floor(from_corner);
    const I wanted = hn::Add(corner, hn::ConvertTo(Ints(), floor));
    const I first = hn::Min(hn::Max(wanted, set(0)), set(count - 2));
    const V moved = hn::ConvertTo(Floats(), hn::Sub(wanted, first));
    return {first, between(set(0.0F), hn::Add(hn::Sub(from_corner, floor), moved), set(1.0F))};
}

// LitGround::looked_up.
class Cells {
  public:
    HWY_INLINE Cells(const LitGround::Raster& raster, Between column, Between row, I in_shadow)
        : samples_(raster.samples),
          first_(hn::ShiftLeft<2>(hn::Add(hn::Add(hn::Mul(row.first, set(raster.columns)), column.first),
                                          hn::Mul(in_shadow, set(raster.columns * raster.rows))))),
          below_(hn::Add(first_, set(4 * raster.columns))),
          height_(hn::GatherIndex(Floats(), samples_ + 3, first_)) {
        const V one = set(1.0F);
        const V if_joined = hn::Max(hn::Sub(hn::Add(column.share, row.share), one), set(0.0F));
        const V if_not = hn::Min(column.share, row.share);
        const auto is_joined = hn::Lt(hn::BitCast(Ints(), height_), set(0));
        opposite_ = hn::IfThenElse(hn::RebindMask(Floats(), is_joined), if_joined, if_not);
        beside_ = hn::Sub(column.share, opposite_);
        under_ = hn::Sub(row.share, opposite_);
        weight_ = hn::Sub(hn::Sub(hn::Sub(one, beside_), under_), opposite_);
    }

    HWY_INLINE V channel(int c) const { return mixed(hn::GatherIndex(Floats(), samples_ + c, first_), c); }
    HWY_INLINE V height() const { return mixed(hn::Abs(height_), 3); }

  private:
    HWY_INLINE V mixed(V first, int c) const {
        const auto other = [&](int offset, I from) {
            return hn::Abs(hn::GatherIndex(Floats(), samples_ + offset + c, from));
        };
        const V above = hn::Add(hn::Mul(weight_, first), hn::Mul(beside_, other(4, first_)));
        return hn::Add(hn::Add(above, hn::Mul(under_, other(0, below_))), hn::Mul(opposite_, other(4, below_)));
    }

    const float* samples_;
    I first_, below_;
    V height_, opposite_, beside_, under_, weight_;
};

HWY_INLINE void look(const GroundRuns& runs, const LitGround::Raster& raster, GroundNodes& nodes, std::size_t i) {
    const Floats d;
    const I run = hn::Load(Ints(), nodes.run.data() + i);
    const V v = hn::Load(d, nodes.v.data() + i);
    const V inverse = hn::Div(set(1.0F), at(runs.over, run, v));
    const V from_column = between(of_runs(runs.least_column, run), hn::Mul(inverse, at(runs.columns, run, v)),
                                  of_runs(runs.most_column, run));
    const V from_row =
        between(of_runs(runs.least_row, run), hn::Mul(inverse, at(runs.rows, run, v)), of_runs(runs.most_row, run));
    const Cells cells(raster, samples_beside(of_runs(runs.triangles.column[0], run), from_column, raster.columns),
                      samples_beside(of_runs(runs.triangles.row[0], run), from_row, raster.rows),
                      of_runs(runs.in_shadow, run));
    hn::Store(from_column, d, nodes.from_column.data() + i);
    hn::Store(from_row, d, nodes.from_row.data() + i);
    AirViews& views = nodes.views;
    hn::Store(cells.channel(0), d, views.red.data() + i);
    hn::Store(cells.channel(1), d, views.green.data() + i);
    hn::Store(cells.channel(2), d, views.blue.data() + i);
    hn::Store(cells.height(), d, views.to_height_m.data() + i);
    const V depth = between(set(0.0F), hn::Mul(inverse, at(runs.depths, run, v)), set(kFarthest_m));
    hn::Store(depth, d, nodes.depth_m.data() + i);
    hn::Store(hn::Mul(depth, at(runs.per_depth, run, v)), d, views.distance_m.data() + i);
    hn::Store(of_runs(runs.from_height_m, run), d, views.from_height_m.data() + i);
    hn::Store(at(runs.towards_sun, run, v), d, views.towards_sun.data() + i);
}

}  // namespace ground_nodes

void look_at_all(const GroundRuns& runs, const LitGround::Raster& raster, GroundNodes& nodes, std::size_t count) {
    for (std::size_t i = 0; i < count; i += hwy::HWY_NAMESPACE::Lanes(ground_nodes::Floats()))
        ground_nodes::look(runs, raster, nodes, i);
}

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(look_at_all);

void look_at_ground(const GroundRuns& runs, const LitGround& light, GroundNodes& nodes, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(look_at_all)(runs, light.raster(), nodes, count);
}
}  // namespace overfly
#endif
