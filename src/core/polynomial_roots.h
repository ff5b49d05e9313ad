#pragma once

#include <array>
#include <cstddef>

#include "core/bernstein.h"

namespace overfly {

// Roots in [0, 1], ascending.
template <std::size_t N>
struct Roots {
    std::array<double, N> u{};
    std::size_t count = 0;

    [[nodiscard]] const double* begin() const { return u.data(); }
    [[nodiscard]] const double* end() const { return u.data() + count; }

    constexpr void add(double root) { u[count++] = root; }
};

// An extreme of a polynomial that comes this near to zero, times its degree times its largest coefficient, touches zero
// and does not pass it. Derivation: de Casteljau's algorithm is within 3 * 2^-53 of the exact value in the same
// measure, and the place of the extreme adds a second-order error; so that what is exactly a touch is taken for one.
inline constexpr double kTouch = 4.0 * 0x1p-53;

// Where |p(u)| is greater than this in the same measure, the changes of sign returned give p(u) its right sign: kTouch,
// the error of de Casteljau's algorithm, and what touches of the derivatives leave out.
inline constexpr double kSignCertain = 16.0 * 0x1p-53;

// Every place inside (0, 1) where the polynomial p changes sign, for any N from 1 to 12. In what follows q is p with
// its roots at exactly 0 and 1 (vanishing first and last coefficients) divided out, n its degree, L = n largest(q).
// GUARANTEES:
// - Where |q(u)| > kSignCertain L, the sign of p(u) is that of p just right of 0, turned once for every root below u.
//   Hence every simple root r is returned, with an error below kSignCertain L / |q'(r)|: 1e-12 where |q'(r)| is above
//   2e-3 L and the next root further than a few times that.
// - Even or odd: as many roots, modulo 2, as the first and the last coefficient of q differ in sign; and no more than
//   the coefficients change sign.
// - A root of even order, or a pair of roots between which |q| stays below kTouch L, is no change of sign and is left
//   out; a pair between which it exceeds kSignCertain L is returned as two; between the two bounds rounding decides,
//   for both together: never one of them. Three roots as near to each other as that are one.
// - A root at exactly 0 or 1 is no change of sign: p has nothing beyond it.
// - Equal coefficients have equal roots, bit by bit; and so have coefficients times -1 or a power of two, unless that
//   rounds them (denormals).
// - Coefficients of any finite magnitude. If one is not finite, or all are zero: no roots.
template <std::size_t N>
[[nodiscard]] Roots<N> sign_change_roots(const Bernstein<N>& b);

extern template Roots<1> sign_change_roots<1>(const Bernstein<1>&);
extern template Roots<2> sign_change_roots<2>(const Bernstein<2>&);
extern template Roots<3> sign_change_roots<3>(const Bernstein<3>&);
extern template Roots<4> sign_change_roots<4>(const Bernstein<4>&);
extern template Roots<5> sign_change_roots<5>(const Bernstein<5>&);
extern template Roots<6> sign_change_roots<6>(const Bernstein<6>&);
extern template Roots<7> sign_change_roots<7>(const Bernstein<7>&);
extern template Roots<8> sign_change_roots<8>(const Bernstein<8>&);
extern template Roots<9> sign_change_roots<9>(const Bernstein<9>&);
extern template Roots<10> sign_change_roots<10>(const Bernstein<10>&);
extern template Roots<11> sign_change_roots<11>(const Bernstein<11>&);
extern template Roots<12> sign_change_roots<12>(const Bernstein<12>&);

}  // namespace overfly
