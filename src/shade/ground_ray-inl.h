// Rays of a piece of the camera's motion and triangles of the ground, as many at once as a vector holds. For Highway:
// included once for each vector unit, by .cpp files that have included hwy/foreach_target.h and hwy/highway.h.
#if defined(OVERFLY_SHADE_GROUND_RAY_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERFLY_SHADE_GROUND_RAY_INL_H
#undef OVERFLY_SHADE_GROUND_RAY_INL_H
#else
#define OVERFLY_SHADE_GROUND_RAY_INL_H
#endif

#include <array>
#include <cstddef>

#include "flight/motion.h"
#include "shade/daylight.h"
#include "shade/ground_triangles.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace ground_ray {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, 8>;
using V = hn::Vec<Doubles>;

HWY_INLINE V set(double x) { return hn::Set(Doubles(), x); }

struct V3 {
    V x, y, z;
};

// The operations of core/geometry.h in their order, none of them fused, so that all vector units agree.
HWY_INLINE V3 set(Vector<Scene> v) { return {set(v.x), set(v.y), set(v.z)}; }
HWY_INLINE V3 set(Point<Scene> p) { return {set(p.x), set(p.y), set(p.z)}; }
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
template <class Lane>
HWY_INLINE V load(const Lane& lane, std::size_t i) {
    return hn::Load(Doubles(), lane.data() + i);
}
template <class Lane>
HWY_INLINE V3 load3(const std::array<Lane, 3>& lanes, std::size_t i) {
    return {load(lanes[0], i), load(lanes[1], i), load(lanes[2], i)};
}

// Where two corners of triangles are in the raster, as their difference along one of its axes.
HWY_INLINE V from_first(const std::array<GroundTriangles::Lane<std::int32_t>, 3>& corner, std::size_t k,
                        std::size_t i) {
    const hn::Rebind<std::int32_t, Doubles> ints;
    const auto samples = hn::Sub(hn::Load(ints, corner[k].data() + i), hn::Load(ints, corner[0].data() + i));
    return hn::PromoteTo(Doubles(), samples);
}

// Rays of film points.
class Rays {
  public:
    HWY_INLINE Rays(const MotionPiece& scene, V x, V y) : scene_(scene), x_(x), y_(y) {}

    HWY_INLINE V3 direction(V u) const {
        return add(add(scale(x_, at(scene_.right, u)), scale(y_, at(scene_.down, u))), at(scene_.view, u));
    }
    // Relative to the piece's reference.
    HWY_INLINE V3 origin(V u) const { return at(scene_.origin, u); }
    // Of the origin, from the middle of an Earth that is a ball.
    HWY_INLINE V3 from_middle(V u) const {
        const V3 p = add(set(reference()), origin(u));
        return {p.x, p.y, hn::Add(p.z, set(kEarthRadius_m))};
    }
    // Of the origin, as height_over_ball_m has it.
    HWY_INLINE V height_over_ball_m(V u) const {
        const V3 p = from_middle(u);
        return hn::Sub(hn::Sqrt(dot(p, p)), set(kEarthRadius_m));
    }
    [[nodiscard]] HWY_INLINE Point<Scene> reference() const { return scene_.reference; }

  private:
    const MotionPiece& scene_;
    V x_, y_;
};

// Triangles by corner, and where rays meet them: Moller and Trumbore's determinants (1997), which have one denominator.
class Triangles {
  public:
    HWY_INLINE Triangles(const GroundTriangles& triangles, std::size_t i)
        : p0_(load3(triangles.corner[0], i)),
          e1_(sub(load3(triangles.corner[1], i), p0_)),
          e2_(sub(load3(triangles.corner[2], i), p0_)),
          normal_(cross(e1_, e2_)) {}

    // Planar depth and shares of corners 1 and 2, each times `over`.
    struct Meeting {
        V depth, share1, share2, over;
    };
    HWY_INLINE Meeting meet(const Rays& rays, V u, V3 direction) const {
        const V3 from = sub(rays.origin(u), sub(p0_, set(rays.reference())));
        const V3 turned = cross(from, direction);
        return {dot(from, normal_), dot(e2_, turned), hn::Neg(dot(e1_, turned)), hn::Neg(dot(direction, normal_))};
    }

  private:
    V3 p0_, e1_, e2_, normal_;
};

}  // namespace ground_ray
}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#endif  // OVERFLY_SHADE_GROUND_RAY_INL_H
