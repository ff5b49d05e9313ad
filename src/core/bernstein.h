#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace overfly {

// A polynomial of degree N on [0, 1] by its Bernstein coefficients b_i: sum b_i C(N,i) u^i (1-u)^(N-i).
// It lies within the range of its coefficients, takes its first and last at 0 and 1, and has at most as many roots
// inside as the coefficients change sign (Farouki 2012, "The Bernstein polynomial basis", sections 4 and 5).
template <std::size_t N>
using Bernstein = std::array<double, N + 1>;

// de Casteljau's algorithm. GUARANTEES: for finite b and u in [0, 1] within 3 N 2^-53 largest(b) of the exact value
// (three roundings a level; Farouki and Rajan 1987).
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

[[nodiscard]] constexpr double binomial(std::size_t n, std::size_t k) {
    double b = 1.0;
    for (std::size_t i = 1; i <= k; ++i) b = b * static_cast<double>(n + 1 - i) / static_cast<double>(i);
    return b;
}

// Coefficient K of a product: the sum over i of C(A-1,i) C(B-1,K-i) / C(A+B-2,K) a_i b_(K-i), with i from `First` on.
template <std::size_t K, std::size_t First, std::size_t A, std::size_t B, std::size_t... I>
[[nodiscard]] constexpr double product_coefficient(const std::array<double, A>& a, const std::array<double, B>& b,
                                                   std::index_sequence<I...>) {
    constexpr std::array<double, sizeof...(I)> kWeight = {binomial(A - 1, First + I) *
                                                          binomial(B - 1, K - First - I)...};
    constexpr double kWhole = binomial(A + B - 2, K);
    if constexpr (A == 1 || B == 1) {
        return a[First] * b[K - First];
    } else {
        return (... + (kWeight[I] * (a[First + I] * b[K - First - I]))) / kWhole;
    }
}

// The product of polynomials of degree A - 1 and B - 1 (Farouki 2012, section 4.5).
template <std::size_t A, std::size_t B>
[[nodiscard]] constexpr std::array<double, A + B - 1> operator*(const std::array<double, A>& a,
                                                                const std::array<double, B>& b) {
    return [&]<std::size_t... K>(std::index_sequence<K...>) {
        return std::array<double, A + B - 1>{product_coefficient<K, (K < B ? 0 : K - B + 1)>(
            a, b, std::make_index_sequence<(K < A ? K : A - 1) - (K < B ? 0 : K - B + 1) + 1>())...};
    }
    (std::make_index_sequence<A + B - 1>());
}

// The coefficients over [from, to] of c0 + c1 u + c2 u^2.
[[nodiscard]] constexpr Bernstein<2> quadratic_over(double c0, double c1, double c2, double from, double to) {
    return {c0 + from * (c1 + from * c2), c0 + 0.5 * (from + to) * c1 + from * to * c2, c0 + to * (c1 + to * c2)};
}

// Times the sign changes along the coefficients, zeros left out.
template <std::size_t N>
[[nodiscard]] constexpr int sign_changes(const Bernstein<N>& b) {
    // Zeros are rare. Without them nothing has to branch, where signs are what no processor predicts.
    int zeros = b[N] == 0.0 ? 1 : 0;
    int changes = 0;
    for (std::size_t i = 0; i < N; ++i) {
        zeros += b[i] == 0.0 ? 1 : 0;
        changes += (b[i] < 0.0) != (b[i + 1] < 0.0) ? 1 : 0;
    }
    if (zeros == 0) return changes;
    changes = 0;
    double last = 0.0;
    for (const double c : b) {
        if (c == 0.0) continue;
        if (last != 0.0 && (c < 0.0) != (last < 0.0)) ++changes;
        last = c;
    }
    return changes;
}

// The greatest magnitude among the coefficients, which bounds the polynomial on [0, 1]. NaNs are passed over.
template <std::size_t N>
[[nodiscard]] double largest(const Bernstein<N>& b) {
    double most = 0.0;
    for (const double c : b) most = std::max(most, std::abs(c));
    return most;
}

// What is left of a polynomial with b_0 = 0 when its root at 0 is divided out, and of one with b_N = 0 at 1.
template <std::size_t N>
[[nodiscard]] constexpr Bernstein<N - 1> divided_by_u(const Bernstein<N>& b) {
    Bernstein<N - 1> q{};
    for (std::size_t i = 0; i < N; ++i) q[i] = b[i + 1] * (static_cast<double>(N) / static_cast<double>(i + 1));
    return q;
}
template <std::size_t N>
[[nodiscard]] constexpr Bernstein<N - 1> divided_by_1_minus_u(const Bernstein<N>& b) {
    Bernstein<N - 1> q{};
    for (std::size_t i = 0; i < N; ++i) q[i] = b[i] * (static_cast<double>(N) / static_cast<double>(N - i));
    return q;
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

}  // namespace overfly
