#include "trace/inside_stretches.h"

#include <algorithm>

#include "core/polynomial_roots.h"
#include "trace/line.h"

namespace overfly {
namespace {

// The side of an edge that the line is on: the same all through, or by a polynomial that changes sign.
template <std::size_t N>
struct Side {
    bool changes = false;
    double constant = 0.0;  // of the sign that it keeps
    std::array<double, N + 1> monomials{};

    [[nodiscard]] double at(double u) const {
        if (!changes) return constant;
        double value = monomials[N];
        for (std::size_t i = N; i > 0; --i) value = monomials[i - 1] + u * value;
        return value;
    }
};

template <std::size_t N, class Cuts>
Side<N> side_of(const Bernstein<N>& b, Cuts& cuts) {
    const auto [least, most] = std::minmax_element(b.begin(), b.end());
    if (*least >= 0.0 || *most <= 0.0) return {false, *least + *most, {}};
    for (const double u : sign_change_roots<N>(b)) cuts.add(u);
    return {true, 0.0, monomials<N>(b)};
}

}  // namespace

template <std::size_t kSide, std::size_t kDepth>
InsideStretches<kSide, kDepth> inside_stretches(const PolynomialLineInCell<kSide, kDepth>& line) {
    StretchCuts<3 * kSide + kDepth> cuts({0.0, 1.0});
    const Side<kSide> first = side_of<kSide>(line.side[0], cuts);
    const Side<kSide> second = side_of<kSide>(line.side[1], cuts);
    const Side<kSide> third = side_of<kSide>(line.side[2], cuts);
    for (const double u : sign_change_roots<kDepth>(line.depth_numerator)) cuts.add(u);
    return cuts.where([&](double u) {
        const EdgeValues values = {{first.at(u), second.at(u), third.at(u)}};
        const double denominator = -(values.at[0] + values.at[1] + values.at[2]);  // as far as its sign goes
        return values.inside() && value_at<kDepth>(line.depth_numerator, u) * denominator > 0.0;
    });
}

template InsideStretches<4, 2> inside_stretches<4, 2>(const LineInCell&);
template InsideStretches<4, 4> inside_stretches<4, 4>(const SunLineInCell&);
template InsideStretches<6, 4> inside_stretches<6, 4>(const TurningSunLineInCell&);

}  // namespace overfly
