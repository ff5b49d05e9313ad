#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/bernstein.h"

namespace overfly {

// Part of [0, 1] in which a polynomial changes sign once.
struct Bracket {
    double lo, hi;
    bool rising;   // negative at lo, positive at hi
    double guess;  // in [lo, hi]
};

// The first terms of the Taylor series of a polynomial, c_0 + c_1 h + ... + c_4 h^4.
using Taylor = std::array<double, 5>;

// The series at u. They are differences along the levels of de Casteljau's algorithm, whose last is the value itself:
// as accurate as value_at, where powers of u would lose digits by cancellation, more the higher N is.
template <std::size_t N>
[[nodiscard]] constexpr Taylor taylor_at(Bernstein<N> b, double u) {
    constexpr auto kN = static_cast<double>(N);
    Taylor c{};
    for (std::size_t n = N; n > 0; --n) {
        if (n == 1) c[1] = kN * (b[1] - b[0]);
        if constexpr (N >= 2) {
            if (n == 2) c[2] = kN * (kN - 1) / 2 * ((b[2] - b[1]) - (b[1] - b[0]));
        }
        if constexpr (N >= 3) {
            if (n == 3) c[3] = kN * (kN - 1) * (kN - 2) / 6 * ((b[3] - b[0]) - 3.0 * (b[2] - b[1]));
        }
        if constexpr (N >= 4) {
            if (n == 4) {
                c[4] = kN * (kN - 1) * (kN - 2) * (kN - 3) / 24 * ((b[0] + b[4]) - 4.0 * (b[1] + b[3]) + 6.0 * b[2]);
            }
        }
        for (std::size_t i = 0; i < n; ++i) b[i] = (1.0 - u) * b[i] + u * b[i + 1];
    }
    c[0] = b[0];
    return c;
}

// A step from a place to a root near it.
struct RootStep {
    double h;
    bool is_last;  // what the step leaves out is less than rounding
};

// The series solved for its root: s (1 - x2 + (2 x2^2 - x3) + (5 x2 x3 - 5 x2^3 - x4)) + ..., s = -c0 / c1 being
// Newton's step and x_k = (c_k / c1) s^(k-1). The products that follow, 14 x2^4 - 21 x2^2 x3 + 3 x3^2 + 6 x2 x4 and so
// on, are below 14 (y^2 + |x2 x4|), y = x2^2 + |x3| + |x4|, and for small x_k together below twice that.
template <std::size_t N>
[[nodiscard]] RootStep step_to_root(const Taylor& c) {
    // The rest that a last step may leave, in u.
    constexpr double kRest = 0x1p-54;
    // Where the series is used at all.
    constexpr double kSmall = 0x1p-6;
    // Terms of order 5 and above, which the series lacks when N > 4, are below C(N,5) 2^5 |h|^5 of the largest
    // coefficient, times less than 2 in all: under its rounding for a step this short, up to degree 12.
    constexpr double kReach = N <= 4 ? 1.0 : 0x1p-14;
    const double inverse = 1.0 / c[1];
    const double s = -c[0] * inverse;
    const double x2 = c[2] * inverse * s;
    const double x3 = c[3] * inverse * s * s;
    const double x4 = c[4] * inverse * (s * s) * s;
    const double y = x2 * x2 + std::abs(x3) + std::abs(x4);
    if (!(y <= kSmall)) return {s, false};
    const double h = s * (1.0 - x2 + (2.0 * x2 * x2 - x3) + (5.0 * x2 * (x3 - x2 * x2) - x4));
    return {h, 28.0 * (y * y + std::abs(x2 * x4)) * std::abs(s) <= kRest && std::abs(s) <= kReach};
}

// The place in a bracket where the polynomial changes sign, by steps of order 5 (Newton's method with three further
// terms of the inverse series; Householder 1970), kept inside the bracket, which shrinks with each; a step that leaves
// it or is not half as long as the one before it becomes a bisection.
// REQUIRES: coefficients between 2^-960 and 2^960, or zero; opposite signs at the ends of the bracket; any further
// changes of sign between them no deeper than rounding.
// GUARANTEES: within 2^-52 of a change of sign of the value as computed by value_at, or nearer than its error can tell.
template <std::size_t N>
[[nodiscard]] double root_between(const Bernstein<N>& b, const Bracket& bracket) {
    // Doubles have 53 bits: as many bisections, and for each at most a handful of steps that were no better.
    constexpr int kMostSteps = 256;
    constexpr double kNarrow = 0x1p-53;
    double lo = bracket.lo;
    double hi = bracket.hi;
    double u = bracket.guess;
    double longest = hi - lo;
    for (int count = 0; count < kMostSteps && hi - lo > kNarrow; ++count) {
        const Taylor c = taylor_at<N>(b, u);
        if (c[0] == 0.0) return u;
        ((c[0] < 0.0) == bracket.rising ? lo : hi) = u;
        const bool leads_inside = bracket.rising ? c[1] > 0.0 : c[1] < 0.0;
        const RootStep step = step_to_root<N>(c);
        const double next = u + step.h;
        if (leads_inside && step.is_last) return std::clamp(next, lo, hi);
        if (leads_inside && next > lo && next < hi && std::abs(step.h) <= longest) {
            u = next;
            longest = 0.5 * std::abs(step.h);
        } else {
            u = 0.5 * (lo + hi);
            longest = 0.5 * (hi - lo);
        }
    }
    return u;
}

}  // namespace overfly
