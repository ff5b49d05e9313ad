// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/ground_looks.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "shade/daylight.h"
#include "shade/ground_looks.h"
#include "shade/lit_ground.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace ground_looks {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using V = hn::Vec<Doubles>;

HWY_INLINE V set(double x) { return hn::Set(Doubles(), x); }

struct V3 {
    V x, y, z;
};

// The operations of core/geometry.h in their order, none of them fused.
HWY_INLINE V3 set(Vector<Scene> v) { return {set(v.x), set(v.y), set(v.z)}; }
HWY_INLINE V3 add(V3 a, V3 b) { return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)}; }
HWY_INLINE V3 sub(V3 a, V3 b) { return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)}; }
HWY_INLINE V3 scale(V s, V3 a) { return {hn::Mul(s, a.x), hn::Mul(s, a.y), hn::Mul(s, a.z)}; }
HWY_INLINE V dot(V3 a, V3 b) { return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z)); }
HWY_INLINE V3 cross(V3 a, V3 b) {
    return {hn::Sub(hn::Mul(a.y, b.z), hn::Mul(a.z, b.y)), hn::Sub(hn::Mul(a.z, b.x), hn::Mul(a.x, b.z)),
            hn::Sub(hn::Mul(a.x, b.y), hn::Mul(a.y, b.x))};
}
HWY_INLINE V3 at(const QuadraticVector& q, V u) {
    return add(set(q.c0), scale(u, add(set(q.c1), scale(u, set(q.c2)))));
}
HWY_INLINE V load(const GroundLooks::Lane<double>& lane, std::size_t i) { return hn::Load(Doubles(), lane.data() + i); }
HWY_INLINE V3 load(const GroundLooks::Lane3<double>& lane, std::size_t i) {
    return {load(lane[0], i), load(lane[1], i), load(lane[2], i)};
}
HWY_INLINE void store(V v, GroundLooks::Lane<double>& lane, std::size_t i) { hn::Store(v, Doubles(), lane.data() + i); }

// As many looks as a vector holds.
class Some {
  public:
    HWY_INLINE Some(const MotionPiece& scene, GroundLooks& looks, std::size_t first)
        : scene_(scene),
          looks_(looks),
          i_(first),
          p0_(load(looks.corner[0], first)),
          e1_(sub(load(looks.corner[1], first), p0_)),
          e2_(sub(load(looks.corner[2], first), p0_)),
          normal_(cross(e1_, e2_)),
          column0_(load(looks.column[0], first)),
          row0_(load(looks.row[0], first)),
          column1_(hn::Sub(load(looks.column[1], first), column0_)),
          row1_(hn::Sub(load(looks.row[1], first), row0_)),
          column2_(hn::Sub(load(looks.column[2], first), column0_)),
          row2_(hn::Sub(load(looks.row[2], first), row0_)) {}

    HWY_INLINE void meet(Vector<Scene> to_sun, double lowest_m) const {
        const V u = load(looks_.u, i_);
        const V twice_area = hn::Abs(hn::Sub(hn::Mul(column1_, row2_), hn::Mul(row1_, column2_)));
        const auto covers = hn::Gt(twice_area, set(1.0));
        const Hit from = hit(hn::IfThenElse(covers, load(looks_.from_u, i_), u));
        const Hit to = hit(hn::IfThenElse(covers, load(looks_.to_u, i_), u));
        store_way(from, to);
        const V depth = hn::Mul(set(0.5), hn::Add(from.depth, to.depth));
        store(depth, looks_.depth_m, i_);
        const V3 d = direction(u);
        const V per_depth = hn::Sqrt(dot(d, d));
        store(hn::Mul(depth, per_depth), looks_.distance_m, i_);
        store(dot(scale(hn::Div(set(1.0), per_depth), d), set(to_sun)), looks_.towards_sun, i_);
        V3 origin =
            add(set(Vector<Scene>{scene_.reference.x, scene_.reference.y, scene_.reference.z}), at(scene_.origin, u));
        origin.z = hn::Add(origin.z, set(kEarthRadius_m));
        const V height = hn::Sub(hn::Sqrt(dot(origin, origin)), set(kEarthRadius_m));
        store(hn::Sub(height, set(lowest_m)), looks_.from_height_m, i_);
    }

  private:
    HWY_INLINE V3 direction(V u) const {
        const V3 right = scale(load(looks_.x, i_), at(scene_.right, u));
        const V3 down = scale(load(looks_.y, i_), at(scene_.down, u));
        return add(add(right, down), at(scene_.view, u));
    }

    struct Hit {
        V depth, column, row;
    };
    // GroundTriangle::hit and place.
    HWY_INLINE Hit hit(V u) const {
        const V3 d = direction(u);
        const V3 reference = set(Vector<Scene>{scene_.reference.x, scene_.reference.y, scene_.reference.z});
        const V3 from = sub(at(scene_.origin, u), sub(p0_, reference));
        const V3 turned = cross(from, d);
        const V inverse = hn::Div(set(-1.0), dot(d, normal_));
        const V b1 = inside(hn::Mul(inverse, dot(e2_, turned)), set(1.0));
        const V b2 = inside(hn::Mul(hn::Neg(inverse), dot(e1_, turned)), hn::Sub(set(1.0), b1));
        const auto between = [&](V s0, V s1, V s2) { return hn::Add(hn::Add(s0, hn::Mul(b1, s1)), hn::Mul(b2, s2)); };
        return {hn::Mul(inverse, dot(from, normal_)), between(column0_, column1_, column2_),
                between(row0_, row1_, row2_)};
    }

    // LitGround::way.
    HWY_INLINE void store_way(const Hit& from, const Hit& to) const {
        const V columns = hn::Sub(to.column, from.column), rows = hn::Sub(to.row, from.row);
        const V cells = hn::Max(hn::Abs(columns), hn::Abs(rows));
        const V steps = hn::Min(hn::Max(hn::Ceil(hn::Add(cells, set(kLooksMore))), set(1.0)), set(kMostLooks));
        store(steps, looks_.steps, i_);
        const V step = hn::Div(set(1.0), steps);
        const V step_columns = hn::Mul(step, columns), step_rows = hn::Mul(step, rows);
        store(step_columns, looks_.step_columns, i_);
        store(step_rows, looks_.step_rows, i_);
        store(hn::Add(from.column, hn::Mul(set(0.5), step_columns)), looks_.from_column, i_);
        store(hn::Add(from.row, hn::Mul(set(0.5), step_rows)), looks_.from_row, i_);
    }

    // What is no number becomes 0.
    static HWY_INLINE V inside(V b, V most) {
        return hn::IfThenElseZero(hn::Gt(b, hn::Zero(Doubles())), hn::IfThenElse(hn::Lt(b, most), b, most));
    }

    const MotionPiece& scene_;
    GroundLooks& looks_;
    std::size_t i_;
    V3 p0_, e1_, e2_, normal_;
    V column0_, row0_, column1_, row1_, column2_, row2_;
};

}  // namespace ground_looks

void meet_all(const MotionPiece& scene, Vector<Scene> to_sun, double lowest_m, GroundLooks& looks, std::size_t count) {
    for (std::size_t i = 0; i < count; i += hwy::HWY_NAMESPACE::Lanes(ground_looks::Doubles()))
        ground_looks::Some(scene, looks, i).meet(to_sun, lowest_m);
}

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(meet_all);

void meet_ground(const MotionPiece& scene, Vector<Scene> to_sun, double lowest_m, GroundLooks& looks,
                 std::size_t count) {
    HWY_DYNAMIC_DISPATCH(meet_all)(scene, to_sun, lowest_m, looks, count);
}
}  // namespace overfly
#endif
