// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/ground_looks.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "shade/ground_looks.h"
#include "shade/ground_ray-inl.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace ground_looks {

using namespace ground_ray;  // NOLINT(google-build-using-namespace): of the same vector unit

HWY_INLINE void store(V v, GroundLooks::Lane<double>& lane, std::size_t i) { hn::Store(v, Doubles(), lane.data() + i); }

// What is no number becomes 0.
HWY_INLINE V inside(V share, V most) {
    return hn::IfThenElseZero(hn::Gt(share, hn::Zero(Doubles())), hn::IfThenElse(hn::Lt(share, most), share, most));
}

HWY_INLINE void store_place(const std::array<GroundLooks::Lane<std::int32_t>, 3>& corner, V share1, V share2,
                            GroundLooks::Lane<double>& met, std::size_t i) {
    const V first = hn::PromoteTo(Doubles(), hn::Load(hn::Rebind<std::int32_t, Doubles>(), corner[0].data() + i));
    const V along1 = from_first(corner, 1, i), along2 = from_first(corner, 2, i);
    store(hn::Add(hn::Add(first, hn::Mul(share1, along1)), hn::Mul(share2, along2)), met, i);
}

// As many looks as a vector holds: GroundTriangle::hit and place.
HWY_INLINE void meet(const MotionPiece& scene, Vector<Scene> to_sun, double lowest_m, GroundLooks& looks,
                     std::size_t i) {
    const Rays rays(scene, load(looks.x, i), load(looks.y, i));
    const V u = load(looks.u, i);
    const V3 d = rays.direction(u);
    const Triangles::Meeting met = Triangles(looks.triangles, i).meet(rays, u, d);
    const V inverse = hn::Div(set(1.0), met.over);
    const V share1 = inside(hn::Mul(inverse, met.share1), set(1.0));
    const V share2 = inside(hn::Mul(inverse, met.share2), hn::Sub(set(1.0), share1));
    store_place(looks.triangles.column, share1, share2, looks.met_column, i);
    store_place(looks.triangles.row, share1, share2, looks.met_row, i);
    const V depth = hn::Mul(inverse, met.depth);
    store(depth, looks.depth_m, i);
    const V per_depth = hn::Sqrt(dot(d, d));
    store(hn::Mul(depth, per_depth), looks.distance_m, i);
    store(dot(scale(hn::Div(set(1.0), per_depth), d), set(to_sun)), looks.towards_sun, i);
    store(hn::Sub(rays.height_over_ball_m(u), set(lowest_m)), looks.from_height_m, i);
}

}  // namespace ground_looks

void meet_all(const MotionPiece& scene, Vector<Scene> to_sun, double lowest_m, GroundLooks& looks, std::size_t count) {
    for (std::size_t i = 0; i < count; i += hwy::HWY_NAMESPACE::Lanes(ground_looks::Doubles()))
        ground_looks::meet(scene, to_sun, lowest_m, looks, i);
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
