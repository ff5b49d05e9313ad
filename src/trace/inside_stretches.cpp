#include "trace/inside_stretches.h"

#include <algorithm>

#include "core/polynomial_roots.h"
#include "trace/line.h"

namespace overfly {
namespace {

// Where the cell is cut: its ends, four roots for each edge, two for the plane.
struct Cuts {
    std::array<double, 16> at{};
    std::size_t count = 0;

    void add(double u) { at[count++] = u; }
};

// The side of an edge that the line is on: the same all through, or by a polynomial that changes sign.
struct Side {
    bool changes = false;
    double constant = 0.0;  // of the sign that it keeps
    std::array<double, 5> monomials{};

    [[nodiscard]] double at(double u) const {
        if (!changes) return constant;
        const auto& c = monomials;
        return c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * c[4])));
    }
};

Side side_of(const Bernstein<4>& b, Cuts& cuts) {
    const auto [least, most] = std::minmax_element(b.begin(), b.end());
    if (*least >= 0.0 || *most <= 0.0) return {false, *least + *most, {}};
    for (const double u : sign_change_roots<4>(b)) cuts.add(u);
    return {true, 0.0, monomials<4>(b)};
}

}  // namespace

Stretches inside_stretches(const LineInCell& line) {
    Cuts cuts;
    cuts.add(0.0);
    const Side first = side_of(line.side[0], cuts);
    const Side second = side_of(line.side[1], cuts);
    const Side third = side_of(line.side[2], cuts);
    for (const double u : sign_change_roots<2>(line.depth_numerator)) cuts.add(u);
    cuts.add(1.0);
    if (cuts.count > 3) std::sort(cuts.at.begin(), cuts.at.begin() + static_cast<std::ptrdiff_t>(cuts.count));

    Stretches inside;
    bool goes_on = false;
    for (std::size_t i = 0; i + 1 < cuts.count; ++i) {
        if (cuts.at[i + 1] <= cuts.at[i]) continue;
        const double middle = 0.5 * (cuts.at[i] + cuts.at[i + 1]);
        const EdgeValues values = {{first.at(middle), second.at(middle), third.at(middle)}};
        const double denominator = -(values.at[0] + values.at[1] + values.at[2]);  // as far as its sign goes
        const bool counts = values.inside() && value_at<2>(line.depth_numerator, middle) * denominator > 0.0;
        if (counts && !goes_on) inside.at[inside.count++] = {cuts.at[i], cuts.at[i + 1]};
        if (counts) inside.at[inside.count - 1].end = cuts.at[i + 1];
        goes_on = counts;
    }
    return inside;
}

}  // namespace overfly
