#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/bernstein.h"

namespace overfly::testing {

// Part of [0, 1] and the polynomial's coefficients over it.
template <std::size_t N>
struct Clip {
    double lo, hi;
    Bernstein<N> b;
};

// The coefficients over [from, to] of the interval that `b` is given over, by de Casteljau's algorithm twice.
template <std::size_t N>
[[nodiscard]] Bernstein<N> clipped(Bernstein<N> b, double from, double to) {
    for (std::size_t n = N; n > 0; --n) {
        for (std::size_t i = 0; i < n; ++i) b[i] = (1.0 - from) * b[i] + from * b[i + 1];
    }
    const double part = from < 1.0 ? (to - from) / (1.0 - from) : 0.0;
    for (std::size_t n = 0; n < N; ++n) {
        for (std::size_t i = N; i > n; --i) b[i] = (1.0 - part) * b[i - 1] + part * b[i];
    }
    return b;
}

// Where one chain of the convex hull of the points (i / N, b_i) crosses zero, added to [least, most]; `side` is 1 for
// the lower chain and -1 for the upper.
template <std::size_t N>
void add_crossings(const Bernstein<N>& b, double side, double& least, double& most) {
    std::array<std::size_t, N + 1> chain{};
    std::size_t count = 0;
    const auto turn = [&](std::size_t i, std::size_t j, std::size_t k) {
        return side * (static_cast<double>(j - i) * (b[k] - b[i]) - static_cast<double>(k - i) * (b[j] - b[i]));
    };
    for (std::size_t k = 0; k <= N; ++k) {
        while (count >= 2 && turn(chain[count - 2], chain[count - 1], k) <= 0.0) --count;
        chain[count++] = k;
    }
    for (std::size_t c = 1; c < count; ++c) {
        const std::size_t i = chain[c - 1];
        const std::size_t j = chain[c];
        if ((b[i] < 0.0) == (b[j] < 0.0)) continue;
        const double at = static_cast<double>(i) + static_cast<double>(j - i) * (b[i] / (b[i] - b[j]));
        least = std::min(least, at / static_cast<double>(N));
        most = std::max(most, at / static_cast<double>(N));
    }
}

// The roots in [0, 1] by Bezier clipping (Sederberg and Nishita 1990, "Curve intersection using Bezier clipping",
// section 3): the hull of the coefficients bounds the roots, the interval is cut down to it and, when that gains less
// than a fifth, halved. Only what the micro-benchmark compares with: it does not tell double roots from none.
template <std::size_t N>
void bezier_clipping_roots(const Bernstein<N>& b, std::vector<double>& roots) {
    constexpr double kNarrow = 1e-14;
    constexpr double kWorthwhile = 0.8;
    std::array<Clip<N>, 64> stack;
    std::size_t height = 0;
    stack[height++] = {0.0, 1.0, b};
    roots.clear();
    while (height > 0) {
        const Clip<N> clip = stack[--height];
        if (sign_changes<N>(clip.b) == 0) continue;
        const double width = clip.hi - clip.lo;
        double least = 1.0;
        double most = 0.0;
        add_crossings<N>(clip.b, 1.0, least, most);
        add_crossings<N>(clip.b, -1.0, least, most);
        if (width * (most - least) <= kNarrow) {
            roots.push_back(clip.lo + width * 0.5 * (least + most));
        } else if (most - least <= kWorthwhile) {
            stack[height++] = {clip.lo + width * least, clip.lo + width * most, clipped<N>(clip.b, least, most)};
        } else {
            const double middle = 0.5 * (clip.lo + clip.hi);
            stack[height++] = {middle, clip.hi, clipped<N>(clip.b, 0.5, 1.0)};
            stack[height++] = {clip.lo, middle, clipped<N>(clip.b, 0.0, 0.5)};
        }
    }
}

}  // namespace overfly::testing
