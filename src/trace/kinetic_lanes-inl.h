// The words in which kinetic_stride.cpp speaks of the samples that walk side by side, one in each lane of a vector.
// Part of that file: compiled with it once for each vector unit, hence the guard, and after Highway, which it leaves to
// it.
#if defined(OVERFLY_KINETIC_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OVERFLY_KINETIC_LANES_INL_H
#undef OVERFLY_KINETIC_LANES_INL_H
#else
#define OVERFLY_KINETIC_LANES_INL_H
#endif

#include <array>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {
namespace kinetic_stride {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t kLanes = 16;

using Floats = hn::CappedTag<float, kLanes>;
using Ints = hn::CappedTag<std::int32_t, kLanes>;
using V = hn::Vec<Floats>;
using I = hn::Vec<Ints>;
using M = hn::Mask<Floats>;

// No operation below is fused, and division and root are those of IEEE 754, so that all vector units agree.

template <class T>
using Lane = std::array<T, kLanes>;
template <class T>
using Lane3 = std::array<Lane<T>, 3>;

// The samples that walk at the moment.
struct alignas(64) Walkers {
    Lane<float> u, limit;               // time of the next look at it; where it ends
    Lane<float> since;                  // it has been in `seen` since
    Lane3<float> p, q, r;               // corners: the side p-q was entered through
    std::array<Lane3<float>, 3> line;   // its direction: power, axis
    Lane<std::int32_t> triangle, side;  // what it is thought to be in at u, and the side p-q of it
    Lane<std::int32_t> seen;            // what it is in for certain
    Lane<std::int32_t> arrives;         // -1: it has come through p-q, and the exact time of that is open
    Lane<std::int32_t> stalled;
    Lane<std::int32_t> moved;  // -1: since it was taken up
    Lane<std::int32_t> last;   // its last record
    Lane<std::int32_t> who;
};

struct Vec3 {
    V x, y, z;
};

// A corner beside the line of sight: two coordinates across the line, their speeds, and half their accelerations.
struct Beside {
    V x, y, dx, dy, ddx, ddy;
};

struct EdgeTerms {
    V value, slope, bend;  // value + slope h + bend h^2 + ...
};

HWY_INLINE V mul(V a, V b) { return hn::Mul(a, b); }

HWY_INLINE EdgeTerms edge_terms(const Beside& a, const Beside& b) {
    return {hn::Sub(mul(a.x, b.y), mul(a.y, b.x)),
            hn::Add(hn::Sub(mul(a.dx, b.y), mul(a.dy, b.x)), hn::Sub(mul(a.x, b.dy), mul(a.y, b.dx))),
            hn::Add(hn::Sub(mul(a.dx, b.dy), mul(a.dy, b.dx)),
                    hn::Add(hn::Sub(mul(a.ddx, b.y), mul(a.ddy, b.x)), hn::Sub(mul(a.x, b.ddy), mul(a.y, b.ddx))))};
}

// A time as a fraction, with a denominator above 0; for never the numerator is kNever.
struct Fraction {
    V numerator, denominator;
};
constexpr float kNever = 1e30F;

HWY_INLINE M is_sooner(const Fraction& a, const Fraction& b) {
    return hn::Lt(mul(a.numerator, b.denominator), mul(b.numerator, a.denominator));
}
HWY_INLINE Fraction select(M mask, const Fraction& yes, const Fraction& no) {
    return {hn::IfThenElse(mask, yes.numerator, no.numerator), hn::IfThenElse(mask, yes.denominator, no.denominator)};
}

// How long until the line leaves by this edge: below 0 if it is outside already.
HWY_INLINE Fraction time_to_exit(const EdgeTerms& e) {
    const Floats d;
    const V zero = hn::Zero(d);
    const V two = hn::Set(d, 2.0F);
    const V discriminant = hn::Sub(mul(e.slope, e.slope), mul(hn::Set(d, 4.0F), mul(e.value, e.bend)));
    const V root = hn::Sqrt(hn::Max(discriminant, zero));
    const V sum = hn::Add(root, hn::Abs(e.slope));
    const M falls = hn::Lt(e.slope, zero);
    const V numerator = hn::IfThenElse(falls, mul(two, e.value), sum);
    const V denominator = hn::IfThenElse(falls, sum, hn::Neg(mul(two, e.bend)));
    const M leaves = hn::And(hn::Ge(discriminant, zero), hn::Gt(denominator, zero));
    return select(leaves, Fraction{numerator, denominator}, Fraction{hn::Set(d, kNever), hn::Set(d, 1.0F)});
}

HWY_INLINE V extent(const Beside& b) { return hn::Add(hn::Abs(b.x), hn::Abs(b.y)); }

template <class T>
HWY_INLINE auto load(const Lane<T>& lane, std::size_t first) {
    return hn::Load(hn::CappedTag<T, kLanes>(), &lane[first]);
}
HWY_INLINE void store(V v, Lane<float>& lane, std::size_t first) { hn::Store(v, Floats(), &lane[first]); }
HWY_INLINE void store(I v, Lane<std::int32_t>& lane, std::size_t first) { hn::Store(v, Ints(), &lane[first]); }
HWY_INLINE Vec3 load3(const Lane3<float>& lanes, std::size_t first) {
    return {load(lanes[0], first), load(lanes[1], first), load(lanes[2], first)};
}
HWY_INLINE void store3(const Vec3& v, Lane3<float>& lanes, std::size_t first) {
    store(v.x, lanes[0], first);
    store(v.y, lanes[1], first);
    store(v.z, lanes[2], first);
}
HWY_INLINE Vec3 select(M mask, const Vec3& yes, const Vec3& no) {
    return {hn::IfThenElse(mask, yes.x, no.x), hn::IfThenElse(mask, yes.y, no.y), hn::IfThenElse(mask, yes.z, no.z)};
}
HWY_INLINE I as_ints(M mask) { return hn::VecFromMask(Ints(), hn::RebindMask(Ints(), mask)); }
HWY_INLINE M as_mask(I v) { return hn::RebindMask(Floats(), hn::Lt(v, hn::Zero(Ints()))); }

HWY_INLINE std::uint32_t bits_of(M mask, std::size_t first) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Floats(), mask, bytes);
    return (static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8U) << first;
}

}  // namespace kinetic_stride
}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#endif
