// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shade/air_views.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "shade/air_views.h"
#include "shade/fast_exp-inl.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace air_views {

using namespace fast_exp;  // NOLINT(google-build-using-namespace): of the same vector unit

struct Channel {
    float extinction_per_m, horizon, glow;
};

// Daylight::through_air, `amount` being what it calls so, in metres.
HWY_INLINE void look(const Channel& of, V amount, V towards_sun8, float* HWY_RESTRICT colour,
                     float* HWY_RESTRICT share_left) {
    const Floats d;
    const V left = exp_of_negative(hn::Neg(hn::Mul(amount, set(of.extinction_per_m))));
    const V haze = hn::Mul(set(of.horizon), hn::Add(set(1.0F), hn::Mul(towards_sun8, set(of.glow))));
    const V seen = hn::Add(hn::Mul(hn::Load(d, colour), left), hn::Mul(haze, hn::Sub(set(1.0F), left)));
    hn::Store(seen, d, colour);
    hn::Store(left, d, share_left);
}

}  // namespace air_views

void look_through_all(const Air& air, AirViews& views, std::size_t count) {
    using namespace air_views;  // NOLINT(google-build-using-namespace): of this function's own words
    const Floats d;
    const V zero = hn::Zero(d), one = set(1.0F);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const V from = hn::Load(d, views.from_height_m.data() + i), to = hn::Load(d, views.to_height_m.data() + i);
        const V a = hn::Div(hn::Min(from, to), set(air.scale_height_m));
        const V b = hn::Div(hn::Max(from, to), set(air.scale_height_m));
        const V difference = hn::Sub(b, a);
        const V at_lower = exp_of_negative(hn::Neg(hn::Max(a, zero)));
        const V by_quotient = hn::Div(hn::Sub(one, exp_of_negative(hn::Neg(difference))), difference);
        const V by_series = hn::Sub(one, hn::Mul(set(0.5F), difference));
        const V mean = hn::IfThenElse(hn::Gt(difference, set(0.01F)), by_quotient, by_series);
        const V amount = hn::Mul(hn::Mul(at_lower, mean), hn::Load(d, views.distance_m.data() + i));
        V power = hn::Max(hn::Load(d, views.towards_sun.data() + i), zero);
        for (int k = 0; k < 3; ++k) power = hn::Mul(power, power);
        look({air.extinction_per_m.r, air.horizon.r, air.glow.r}, amount, power, views.red.data() + i,
             views.red_left.data() + i);
        look({air.extinction_per_m.g, air.horizon.g, air.glow.g}, amount, power, views.green.data() + i,
             views.green_left.data() + i);
        look({air.extinction_per_m.b, air.horizon.b, air.glow.b}, amount, power, views.blue.data() + i,
             views.blue_left.data() + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(look_through_all);

void look_through(const Air& air, AirViews& views, std::size_t count) {
    HWY_DYNAMIC_DISPATCH(look_through_all)(air, views, count);
}
}  // namespace overfly
#endif
