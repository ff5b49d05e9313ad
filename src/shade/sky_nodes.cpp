// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/sky_nodes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>

#include "shade/fast_exp-inl.h"
#include "shade/ground_ray-inl.h"
#include "shade/sky_nodes.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace sky_nodes {

namespace hn = hwy::HWY_NAMESPACE;

// What all nodes have in common.
struct Surroundings {
    Vector<Scene> to_sun;
    double earth_m, lowest_m;  // the Earth's height, and the one that heights in the air are counted from
};

// Where rays go to. Of the Earth near the horizon this takes double precision; of all else single will do.
class Geometry {
    using Doubles = ground_ray::Doubles;
    using V = ground_ray::V;
    using V3 = ground_ray::V3;
    static HWY_INLINE V set(double x) { return ground_ray::set(x); }

  public:
    static HWY_INLINE void find(const MotionPiece& scene, const Surroundings& around, SkyNodes& nodes, std::size_t i) {
        using ground_ray::dot;
        const V u = ground_ray::load(nodes.u, i), zero = hn::Zero(Doubles());
        const ground_ray::Rays rays(scene, ground_ray::load(nodes.x, i), ground_ray::load(nodes.y, i));
        const V3 along = rays.direction(u), from_middle = rays.from_middle(u);
        const V3 direction = ground_ray::scale(hn::Div(set(1.0), hn::Sqrt(dot(along, along))), along);
        const V square = dot(from_middle, from_middle), from_middle_m = hn::Sqrt(square);
        const V rising_m = dot(from_middle, direction);
        store(hn::Max(hn::Div(rising_m, from_middle_m), zero), nodes.rise, i);
        store(dot(direction, ground_ray::set(around.to_sun)), nodes.views.towards_sun, i);

        // FarGround::distance_m.
        const double radius_m = kEarthRadius_m + around.earth_m;
        const V height_m = hn::Sub(from_middle_m, set(kEarthRadius_m));
        const V beyond_m2 = hn::Sub(square, set(radius_m * radius_m));
        const V reach_m2 = hn::Sub(hn::Mul(rising_m, rising_m), beyond_m2);
        const auto is_earth =
            hn::And(hn::And(hn::Lt(rising_m, zero), hn::Ge(reach_m2, zero)), hn::Gt(height_m, set(around.earth_m)));
        const V to_earth_m = hn::Div(beyond_m2, hn::Sub(hn::Sqrt(hn::Max(reach_m2, zero)), rising_m));
        store(hn::IfThenElseZero(is_earth, to_earth_m), nodes.views.distance_m, i);
        store(hn::Sub(height_m, set(around.lowest_m)), nodes.views.from_height_m, i);
        const hn::Rebind<std::int32_t, Doubles> ints;
        hn::Store(hn::DemoteTo(ints, hn::IfThenElseZero(is_earth, set(1.0))), ints, nodes.is_earth.data() + i);
    }

  private:
    static HWY_INLINE void store(V v, AirViews::Lane& lane, std::size_t i) {
        const hn::Rebind<float, Doubles> floats;
        hn::Store(hn::DemoteTo(floats, v), floats, lane.data() + i);
    }
};

struct Channel {
    float zenith, horizon, glow;
};

// Daylight::background, where no Earth is.
HWY_INLINE void look(const Channel& of, fast_exp::V towards_sun8, fast_exp::V share_of_horizon,
                     hn::Mask<fast_exp::Floats> is_earth, float* HWY_RESTRICT colour) {
    using fast_exp::set;
    using fast_exp::V;
    const fast_exp::Floats d;
    const V one = set(1.0F);
    const V horizon = hn::Mul(set(of.horizon), hn::Add(one, hn::Mul(towards_sun8, set(of.glow))));
    const V sky = hn::Add(hn::Mul(hn::Sub(one, share_of_horizon), set(of.zenith)), hn::Mul(share_of_horizon, horizon));
    hn::Store(hn::IfThenElse(is_earth, hn::Load(d, colour), sky), d, colour);
}

HWY_INLINE void look(const Daylight& day, SkyNodes& nodes, std::size_t i) {
    using fast_exp::V;
    const fast_exp::Floats d;
    AirViews& views = nodes.views;
    const auto earth = hn::Load(fast_exp::Ints(), nodes.is_earth.data() + i);
    const auto is_earth = hn::RebindMask(d, hn::Gt(earth, hn::Zero(fast_exp::Ints())));
    const V rise = hn::Load(d, nodes.rise.data() + i);
    const V share_of_horizon = fast_exp::exp_of_negative(hn::Div(hn::Neg(rise), fast_exp::set(Daylight::kSkyRise)));
    V power = hn::Max(hn::Load(d, views.towards_sun.data() + i), hn::Zero(d));
    for (int k = 0; k < 3; ++k) power = hn::Mul(power, power);
    const Rgb zenith = day.zenith();
    const Air& air = day.air();
    look({zenith.r, air.horizon.r, air.glow.r}, power, share_of_horizon, is_earth, views.red.data() + i);
    look({zenith.g, air.horizon.g, air.glow.g}, power, share_of_horizon, is_earth, views.green.data() + i);
    look({zenith.b, air.horizon.b, air.glow.b}, power, share_of_horizon, is_earth, views.blue.data() + i);
}

}  // namespace sky_nodes

void find_all_skies(const MotionPiece& scene, const Daylight& day, const LitGround& light, SkyNodes& nodes,
                    std::size_t count) {
    const sky_nodes::Surroundings around = {day.to_sun(), light.far().height_m, light.lowest_m()};
    for (std::size_t i = 0; i < count; i += hwy::HWY_NAMESPACE::Lanes(ground_ray::Doubles()))
        sky_nodes::Geometry::find(scene, around, nodes, i);
}

void look_at_all_skies(const Daylight& day, SkyNodes& nodes, std::size_t count) {
    for (std::size_t i = 0; i < count; i += hwy::HWY_NAMESPACE::Lanes(fast_exp::Floats()))
        sky_nodes::look(day, nodes, i);
}

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(find_all_skies);
HWY_EXPORT(look_at_all_skies);

void look_at_sky(const MotionPiece& scene, const Daylight& day, const LitGround& light, SkyNodes& nodes,
                 std::size_t count) {
    HWY_DYNAMIC_DISPATCH(find_all_skies)(scene, day, light, nodes, count);
    const auto earths =
        std::count(nodes.is_earth.begin(), nodes.is_earth.begin() + static_cast<std::ptrdiff_t>(count), 1);
    if (earths > 0) {
        const Rgb earth = light.far().radiance;
        AirViews& views = nodes.views;
        for (std::size_t i = 0; i < count; ++i) {
            views.set(i, earth,
                      {views.distance_m[i], views.from_height_m[i],
                       static_cast<float>(light.far().height_m - light.lowest_m()), views.towards_sun[i]});
        }
        look_through(day.air(), views, count);
    }
    if (earths < static_cast<std::ptrdiff_t>(count)) HWY_DYNAMIC_DISPATCH(look_at_all_skies)(day, nodes, count);
}
}  // namespace overfly
#endif
