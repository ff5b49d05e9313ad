#include "core/polynomial_roots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/bracketed_root.h"

namespace overfly {
namespace {

// Magnitudes between which neither the products and derivatives of coefficients overflow nor, as far as they matter,
// vanish: squares are taken of quadratics, and eleven derivatives and divisions grow a coefficient by less than 2^100.
constexpr double kLeastMagnitude = 0x1p-100;
constexpr double kMostMagnitude = 0x1p+300;

// The polynomial times the power of two that brings its largest coefficient, `most`, to between 1 and 2. A coefficient
// too small for the new scale keeps its sign, on which the changes at the ends depend.
template <std::size_t N>
[[nodiscard]] Bernstein<N> to_unit_scale(Bernstein<N> b, double most) {
    const int exponent = std::ilogb(most);
    for (double& c : b) {
        const double scaled = std::scalbn(c, -exponent);
        const bool is_lost = c != 0.0 && std::abs(scaled) < std::numeric_limits<double>::min();
        c = is_lost ? std::copysign(std::numeric_limits<double>::min(), c) : scaled;
    }
    return b;
}

template <std::size_t N, std::size_t M>
[[nodiscard]] Roots<N> widened(const Roots<M>& few) {
    Roots<N> roots;
    for (const double u : few) roots.add(u);
    return roots;
}

// In terms of t = u / (1 - u) the quadratic is b_2 t^2 + 2 b_1 t + b_0: no sum of what follows cancels but the
// discriminant, which is small only where the extreme, -D / (b_0 - 2 b_1 + b_2), is.
Roots<2> roots_of_quadratic(const Bernstein<2>& b, int changes) {
    Roots<2> roots;
    const double discriminant = b[1] * b[1] - b[0] * b[2];
    if (changes == 2) {
        const double curvature = std::abs(b[0]) + 2.0 * std::abs(b[1]) + std::abs(b[2]);
        if (discriminant <= kTouch * 2.0 * largest<2>(b) * curvature) return roots;
    }
    // Without a sign of b_1's own that of b_2 serves, so that -b, too, has the very same roots.
    const double q = -(b[1] + std::copysign(std::sqrt(discriminant), b[1] == 0.0 ? b[2] : b[1]));
    if (q == 0.0) {  // the end coefficients' product has vanished: the root is as near to the lesser as can be told
        roots.add(std::abs(b[0]) < std::abs(b[2]) ? 0.0 : 1.0);
        return roots;
    }
    if ((q < 0.0) == (b[0] < 0.0)) roots.add(b[0] / (b[0] + q));
    if ((q < 0.0) == (b[2] < 0.0)) roots.add(q / (q + b[2]));
    return roots;
}

// An end of a stretch: 0, 1, or a place where the derivative changes sign.
struct StretchEnd {
    double u, value;
    bool is_turn;
};

// Where a chord would cross zero; where one end is flat, a parabola.
double guess_between(const StretchEnd& lo, const StretchEnd& hi) {
    double part = lo.value / (lo.value - hi.value);
    if (lo.is_turn && !hi.is_turn) part = std::sqrt(part);
    if (hi.is_turn && !lo.is_turn) part = 1.0 - std::sqrt(1.0 - part);
    return std::clamp(lo.u + (hi.u - lo.u) * part, lo.u, hi.u);
}

template <std::size_t N>
[[nodiscard]] Roots<N> roots_of(const Bernstein<N>& b) {
    const int changes = sign_changes<N>(b);
    Roots<N> roots;
    if (changes == 0) return roots;
    if constexpr (N == 1) {
        roots.add(b[0] / (b[0] - b[1]));
        return roots;
    } else {
        if (b[0] == 0.0) return widened<N>(roots_of<N - 1>(divided_by_u<N>(b)));
        if (b[N] == 0.0) return widened<N>(roots_of<N - 1>(divided_by_1_minus_u<N>(b)));
        if constexpr (N == 2) {
            return roots_of_quadratic(b, changes);
        } else {
            StretchEnd lo = {0.0, b[0], false};
            const auto end_stretch = [&](const StretchEnd& hi) {
                const bool rising = lo.value < 0.0;
                if (rising != (hi.value < 0.0)) {
                    roots.add(root_between<N>(b, {lo.u, hi.u, rising, guess_between(lo, hi)}));
                }
                lo = hi;
            };
            if (changes > 1) {
                const double touch = kTouch * static_cast<double>(N) * largest<N>(b);
                for (const double u : roots_of<N - 1>(derivative<N>(b))) {
                    const double value = value_at<N>(b, u);
                    if (std::abs(value) > touch) end_stretch({u, value, true});
                }
            }
            end_stretch({1.0, b[N], false});
            return roots;
        }
    }
}

}  // namespace

// The roots of the derivative cut [0, 1] into monotone stretches, each with at most one root (Yuksel 2022,
// "High-Performance Polynomial Root Finding for Graphics"). Departures: coefficients that do not change sign, or change
// it once, end the recursion (Descartes' rule); quadratics are solved in closed form; extremes that touch zero end no
// stretch; all evaluation is by de Casteljau's algorithm.
template <std::size_t N>
Roots<N> sign_change_roots(const Bernstein<N>& b) {
    static_assert(N >= 1 && N <= 12);
    double sum = 0.0;
    for (const double c : b) sum += std::abs(c);
    if (sum >= kLeastMagnitude && sum <= kMostMagnitude) {
        return roots_of<N>(b);
    }
    for (const double c : b) {
        if (!std::isfinite(c)) return {};
    }
    if (sum == 0.0) return {};
    return roots_of<N>(to_unit_scale<N>(b, largest<N>(b)));
}

template Roots<1> sign_change_roots<1>(const Bernstein<1>&);
template Roots<2> sign_change_roots<2>(const Bernstein<2>&);
template Roots<3> sign_change_roots<3>(const Bernstein<3>&);
template Roots<4> sign_change_roots<4>(const Bernstein<4>&);
template Roots<5> sign_change_roots<5>(const Bernstein<5>&);
template Roots<6> sign_change_roots<6>(const Bernstein<6>&);
template Roots<7> sign_change_roots<7>(const Bernstein<7>&);
template Roots<8> sign_change_roots<8>(const Bernstein<8>&);
template Roots<9> sign_change_roots<9>(const Bernstein<9>&);
template Roots<10> sign_change_roots<10>(const Bernstein<10>&);
template Roots<11> sign_change_roots<11>(const Bernstein<11>&);
template Roots<12> sign_change_roots<12>(const Bernstein<12>&);

}  // namespace overfly
