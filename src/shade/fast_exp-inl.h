// e^x as fast_exp.h has it, of as many numbers as a vector holds. For Highway: included once for each vector unit, by
// .cpp files that have included hwy/foreach_target.h and hwy/highway.h.
#if defined(OVERFLY_SHADE_FAST_EXP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERFLY_SHADE_FAST_EXP_INL_H
#undef OVERFLY_SHADE_FAST_EXP_INL_H
#else
#define OVERFLY_SHADE_FAST_EXP_INL_H
#endif

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace fast_exp {

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Floats>;
using V = hn::Vec<Floats>;

HWY_INLINE V set(float x) { return hn::Set(Floats(), x); }

// The same operations in the same order, none of them fused, so that all vector units agree with fast_exp.
HWY_INLINE V exp_of_negative(V x) {
    const V power_of_two = hn::Mul(hn::Max(x, set(-87.0F)), set(1.44269504F));
    const auto whole = hn::ConvertTo(Ints(), power_of_two);
    const V f = hn::Sub(power_of_two, hn::ConvertTo(Floats(), whole));
    V q = hn::Add(set(0.00934423F), hn::Mul(f, set(0.00100363F)));
    q = hn::Add(set(0.05540856F), hn::Mul(f, q));
    q = hn::Add(set(0.24021469F), hn::Mul(f, q));
    q = hn::Add(set(0.69314694F), hn::Mul(f, q));
    const auto exponent = hn::ShiftLeft<23>(hn::Add(whole, hn::Set(Ints(), 127)));
    return hn::Mul(hn::Add(set(1.0F), hn::Mul(f, q)), hn::BitCast(Floats(), exponent));
}

}  // namespace fast_exp
}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#endif  // OVERFLY_SHADE_FAST_EXP_INL_H
