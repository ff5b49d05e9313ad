#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace overfly {

// A polynomial of degree N on [0, 1] by its Bernstein coefficients b_i: sum b_i C(N,i) u^i (1-u)^(N-i).
// It lies within the range of its coefficients, takes its first and last at 0 and 1, and has at most as many roots
// inside as the coefficients change sign (Farouki 2012, "The Bernstein polynomial basis", sections 4 and 5).
template <std::size_t N>
using Bernstein = std::array<double, N + 1>;

// Ascending roots in [0, 1].
template <std::size_t N>
struct Roots {
    std::array<double, N> u{};
    std::size_t count = 0;

    [[nodiscard]] const double* begin() const { return u.data(); }
    [[nodiscard]] const double* end() const { return u.data() + count; }
};

// de Casteljau's algorithm.
template <std::size_t N>
[[nodiscard]] constexpr double value_at(Bernstein<N> b, double u) {
    for (std::size_t n = N; n > 0; --n) {
        for (std::size_t i = 0; i < n; ++i) b[i] = (1.0 - u) * b[i] + u * b[i + 1];
    }
    return b[0];
}

template <std::size_t N>
[[nodiscard]] constexpr Bernstein<N - 1> derivative(const Bernstein<N>& b) {
    Bernstein<N - 1> d{};
    for (std::size_t i = 0; i < N; ++i) d[i] = static_cast<double>(N) * (b[i + 1] - b[i]);
    return d;
}

[[nodiscard]] constexpr Bernstein<4> operator*(const Bernstein<2>& a, const Bernstein<2>& b) {
    return {a[0] * b[0], 0.5 * (a[0] * b[1] + a[1] * b[0]), (a[0] * b[2] + 4.0 * (a[1] * b[1]) + a[2] * b[0]) / 6.0,
            0.5 * (a[1] * b[2] + a[2] * b[1]), a[2] * b[2]};
}

// Times the sign changes along the coefficients, zeros left out.
template <std::size_t N>
[[nodiscard]] constexpr int sign_changes(const Bernstein<N>& b) {
    int changes = 0;
    double last = 0.0;
    for (const double c : b) {
        if (c == 0.0) continue;
        if (last != 0.0 && (c < 0.0) != (last < 0.0)) ++changes;
        last = c;
    }
    return changes;
}

// The same polynomial as c_0 + c_1 u + ... + c_N u^N: forward differences of the coefficients times binomials.
template <std::size_t N>
[[nodiscard]] constexpr std::array<double, N + 1> monomials(Bernstein<N> b) {
    double binomial = 1.0;
    for (std::size_t i = 0; i <= N; ++i) {
        for (std::size_t k = N; k > i; --k) b[k] -= b[k - 1];
        b[i] *= binomial;
        binomial *= static_cast<double>(N - i) / static_cast<double>(i + 1);
    }
    return b;
}

// The root of a polynomial that is monotone on [lo, hi] and changes sign there, by Newton steps kept inside the
// shrinking bracket; bisection where a step leaves it. Starts on the chord between the two values. GUARANTEES: within
// kRootTolerance of a place where the computed value changes sign, or nearer than rounding can tell.
inline constexpr double kRootTolerance = 1e-14;

struct Bracket {
    double lo, hi;
    double at_lo, at_hi;  // of opposite signs
};

template <std::size_t N>
[[nodiscard]] double root_between(const std::array<double, N + 1>& c, Bracket bracket) {
    // Doubles have 53 bits: bisection alone would end in as many steps, Newton takes three or four.
    constexpr int kMostSteps = 60;
    const bool rising = bracket.at_lo < 0.0;
    double lo = bracket.lo;
    double hi = bracket.hi;
    double u = lo + (hi - lo) * (bracket.at_lo / (bracket.at_lo - bracket.at_hi));
    for (int step = 0; step < kMostSteps; ++step) {
        double value = c[N];
        double slope = 0.0;
        for (std::size_t i = N; i > 0; --i) {
            slope = slope * u + value;
            value = value * u + c[i - 1];
        }
        ((value < 0.0) == rising ? lo : hi) = u;
        const double newton = u - value / slope;
        if (std::abs(newton - u) <= kRootTolerance) return newton >= lo && newton <= hi ? newton : u;
        u = newton > lo && newton < hi ? newton : 0.5 * (lo + hi);
        if (hi - lo <= kRootTolerance) return u;
    }
    return u;
}

// Every place in [0, 1] where the polynomial changes sign, ascending; a root of even order is not one and is left out.
// The roots of the derivative cut [0, 1] into monotone stretches, each with at most one root (Yuksel 2022,
// "High-Performance Polynomial Root Finding for Graphics"); coefficients that do not change sign, or change it once,
// end the recursion early.
template <std::size_t N>
[[nodiscard]] Roots<N> sign_change_roots(const Bernstein<N>& b) {
    Roots<N> roots;
    const int changes = sign_changes<N>(b);
    if (changes == 0) return roots;
    if constexpr (N == 1) {
        roots.u[roots.count++] = b[0] / (b[0] - b[1]);
    } else {
        const std::array<double, N + 1> c = monomials<N>(b);
        Roots<N - 1> turns;
        if (changes > 1) turns = sign_change_roots<N - 1>(derivative<N>(b));
        double lo = 0.0;
        double at_lo = b[0];
        for (std::size_t i = 0; i <= turns.count; ++i) {
            const double hi = i < turns.count ? turns.u[i] : 1.0;
            const double at_hi = i < turns.count ? value_at<N>(b, hi) : b[N];
            if (at_lo != 0.0 && at_hi != 0.0 && (at_lo < 0.0) != (at_hi < 0.0)) {
                roots.u[roots.count++] = root_between<N>(c, {lo, hi, at_lo, at_hi});
            }
            // A zero at the end of a stretch keeps the sign before it, so that a crossing there is found in the next.
            if (at_hi != 0.0) {
                at_lo = at_hi;
                lo = hi;
            }
        }
    }
    return roots;
}

}  // namespace overfly
