#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "core/polynomial_roots.h"

namespace overfly::testing {

// More digits than the code under test has: 113 bits where the compiler offers them, at the least the 64 of x87.
#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 Quad;
#else
using Quad = long double;
#endif

// de Casteljau's algorithm in the arithmetic of Real, on the coefficients as they are.
template <class Real, std::size_t N>
[[nodiscard]] Real precise_value(const Bernstein<N>& coefficients, Real u) {
    std::array<Real, N + 1> b{};
    for (std::size_t i = 0; i <= N; ++i) b[i] = static_cast<Real>(coefficients[i]);
    for (std::size_t n = N; n > 0; --n) {
        for (std::size_t i = 0; i < n; ++i) b[i] += u * (b[i + 1] - b[i]);
    }
    return b[0];
}

// The sign just right of 0, as the roots' header means it: that of the first coefficient that is not zero.
template <std::size_t N>
[[nodiscard]] bool starts_negative(const Bernstein<N>& b) {
    const auto first = std::ranges::find_if(b, [](double c) { return c != 0.0; });
    return first != b.end() && *first < 0.0;
}

// Whether p changes its sign within `reach` of u: the test of one root to the digits of Quad.
template <std::size_t N>
[[nodiscard]] bool changes_near(const Bernstein<N>& b, double u, double reach) {
    const auto at = static_cast<Quad>(u);
    const auto step = static_cast<Quad>(reach);
    return (precise_value<Quad, N>(b, at - step) < 0) != (precise_value<Quad, N>(b, at + step) < 0);
}

// How p compares with q, which is p with its roots at 0 and 1 divided out: what the header's laws are measured in.
template <std::size_t N>
class WithoutEnds {
  public:
    explicit WithoutEnds(const Bernstein<N>& b) : b_(&b) {
        while (at_0_ < N && b[at_0_] == 0.0) ++at_0_;
        while (at_1_ < N - at_0_ && b[N - at_1_] == 0.0) ++at_1_;
        const std::size_t n = N - at_0_ - at_1_;
        for (std::size_t i = 0; i <= n; ++i) {
            const long double share = binomial(N, i + at_0_) / binomial(n, i);
            measure_ = std::max(measure_, std::abs(static_cast<long double>(b[i + at_0_])) * share);
        }
        measure_ *= static_cast<long double>(n);
    }

    // p(u), or zero where |q(u)| is at most `least` times its degree times its largest coefficient.
    [[nodiscard]] long double value_above(long double least, double u) const {
        const auto value = precise_value<long double, N>(*b_, static_cast<long double>(u));
        long double bound = least * measure_;
        for (std::size_t i = 0; i < at_0_; ++i) bound *= static_cast<long double>(u);
        for (std::size_t i = 0; i < at_1_; ++i) bound *= 1 - static_cast<long double>(u);
        return std::abs(value) > bound ? value : 0;
    }

  private:
    static long double binomial(std::size_t n, std::size_t k) {
        long double product = 1;
        for (std::size_t i = 0; i < k; ++i)
            product *= static_cast<long double>(n - i) / static_cast<long double>(i + 1);
        return product;
    }

    const Bernstein<N>* b_;
    std::size_t at_0_ = 0, at_1_ = 0;
    long double measure_ = 0;
};

// Checks what sign_change_roots guarantees of its result; the law of signs at the `probes` and close to either side of
// each root. Returns the first law that is broken, or nothing.
template <std::size_t N>
[[nodiscard]] std::string broken_law(const Bernstein<N>& b, const Roots<N>& roots, std::vector<double> probes) {
    Bernstein<N> mirrored = b;
    std::ranges::reverse(mirrored);
    if ((roots.count % 2 == 1) != (starts_negative<N>(b) != starts_negative<N>(mirrored))) return "parity";
    if (roots.count > static_cast<std::size_t>(sign_changes<N>(b))) return "Descartes";
    if (!std::is_sorted(roots.begin(), roots.end())) return "order";
    double last = 0.0;
    for (const double u : roots) {
        if (!(u >= 0.0 && u <= 1.0)) return "range";
        probes.insert(probes.end(), {0.5 * (last + u), u - 1e-13, u + 1e-13});
        last = u;
    }
    probes.push_back(0.5 * (last + 1.0));
    const WithoutEnds<N> p(b);
    for (const double u : probes) {
        if (!(u >= 0.0 && u <= 1.0)) continue;
        const long double value = p.value_above(static_cast<long double>(kSignCertain), u);
        if (value == 0) continue;
        const auto below = std::count_if(roots.begin(), roots.end(), [u](double root) { return root < u; });
        if ((value < 0) != (starts_negative<N>(b) != (below % 2 == 1))) return "sign at " + std::to_string(u);
    }
    return {};
}

// The factor (v u - w (1 - u)) of a polynomial with a root at w / (v + w).
template <class Real>
struct RootFactor {
    Real w, v;
};

// The product of N factors as the coefficients of C(N,i) u^i (1-u)^(N-i), each times `multiple`.
template <class Real, std::size_t N>
[[nodiscard]] std::array<Real, N + 1> product_of(const std::array<RootFactor<Real>, N>& factors, Real multiple) {
    std::array<Real, N + 1> c{};
    c[0] = multiple;
    for (std::size_t n = 0; n < N; ++n) {
        for (std::size_t i = n + 1; i > 0; --i) c[i] = c[i - 1] * factors[n].v - c[i] * factors[n].w;
        c[0] = -c[0] * factors[n].w;
    }
    Real binomial = 1;
    for (std::size_t i = 0; i <= N; ++i) {
        c[i] /= binomial;
        binomial = binomial * static_cast<Real>(N - i) / static_cast<Real>(i + 1);
    }
    return c;
}

// A polynomial with these roots, rounded to double once, at the end.
template <std::size_t N>
[[nodiscard]] Bernstein<N> with_roots(const std::array<double, N>& roots) {
    std::array<RootFactor<long double>, N> factors;
    for (std::size_t i = 0; i < N; ++i) {
        const auto root = static_cast<long double>(roots[i]);
        factors[i] = {root, 1 - root};
    }
    const std::array<long double, N + 1> c = product_of<long double, N>(factors, 1);
    Bernstein<N> b{};
    for (std::size_t i = 0; i <= N; ++i) b[i] = static_cast<double>(c[i]);
    return b;
}

// A polynomial with roots at eighths, given as numerators from -8 to 16, exactly: 27720 is divisible by every C(N,i)
// up to N = 12, and the coefficients stay below 2^53 when no more than `N` of twelve are roots inside.
template <std::size_t N>
[[nodiscard]] Bernstein<N> with_eighths(const std::array<int, N>& numerators) {
    std::array<RootFactor<std::int64_t>, N> factors;
    for (std::size_t i = 0; i < N; ++i) factors[i] = {numerators[i], 8 - numerators[i]};
    const std::array<std::int64_t, N + 1> c = product_of<std::int64_t, N>(factors, 27720);
    Bernstein<N> b{};
    for (std::size_t i = 0; i <= N; ++i) b[i] = static_cast<double>(c[i]);
    return b;
}

}  // namespace overfly::testing
