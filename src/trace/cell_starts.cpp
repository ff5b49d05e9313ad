#include "trace/cell_starts.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/polynomial_roots.h"

namespace overfly {
namespace {

// More than a rounding to float.
constexpr double kNearer = 1.0 - 1e-6;
// Beyond anything, and a float still.
constexpr double kFarthest = 1e30;

// What the ratio of two quadratics doesn't fall below on [0, 1], nor zero. As long as the denominator's coefficients
// have one sign, the ratio is a mean of those of the coefficients.
float least_ratio(const Bernstein<2>& numerator, const Bernstein<2>& denominator) {
    const auto [low, high] = std::minmax_element(denominator.begin(), denominator.end());
    if (!(*low > 0.0 || *high < 0.0)) return 0.0F;
    double least = numerator[0] / denominator[0];
    for (std::size_t j = 1; j < 3; ++j) least = std::min(least, numerator[j] / denominator[j]);
    return std::isfinite(least) && least > 0.0 ? static_cast<float>(std::min(least, kFarthest) * kNearer) : 0.0F;
}

}  // namespace

CellStarts::CellStarts(const RayStart& start, const SweptRays& rays) {
    for (std::uint32_t rest = rays.active; rest != 0; rest &= rest - 1) {
        const auto cell = static_cast<std::size_t>(std::countr_zero(rest));
        const TimeRange when = rays.cells->exposure_of(cell);
        const PlaneDepth depth(start.plane.on, start.plane.normal, *start.motion, rays.x[cell], rays.y[cell]);
        const double from = start.motion->u_at(when.begin_s);
        const double to = start.motion->u_at(when.end_s);
        numerator_[cell] = depth.numerator_over(from, to);
        for (double& c : numerator_[cell]) c *= 1.0 + kAtStart;
        denominator_[cell] = depth.denominator_over(from, to);
        nearest_[cell] = least_ratio(numerator_[cell], denominator_[cell]);
        StretchCuts<4> cuts({0.0, 1.0});
        for (const double u : sign_change_roots<2>(numerator_[cell])) cuts.add(u);
        for (const double u : sign_change_roots<2>(denominator_[cell])) cuts.add(u);
        if (cuts.where([&](double u) { return starts(cell, u); }).count > 0) open_ |= 1U << cell;
    }
}

bool CellStarts::starts(std::size_t cell, double u) const {
    return value_at<2>(numerator_[cell], u) * value_at<2>(denominator_[cell], u) > 0.0;
}

CellStarts::Parts CellStarts::before(const Bernstein<2>& numerator, const Bernstein<2>& denominator, std::size_t cell,
                                     Stretch stretch) const {
    const Bernstein<2>& start_numerator = numerator_[cell];
    const Bernstein<2>& start_denominator = denominator_[cell];
    const Bernstein<4> plane = numerator * start_denominator;
    const Bernstein<4> start = start_numerator * denominator;
    Bernstein<4> beyond{};
    for (std::size_t k = 0; k < beyond.size(); ++k) beyond[k] = plane[k] - start[k];
    StretchCuts<10> cuts(stretch);
    for (const double u : sign_change_roots<4>(beyond)) cuts.add(u);
    for (const double u : sign_change_roots<2>(start_numerator)) cuts.add(u);
    for (const double u : sign_change_roots<2>(start_denominator)) cuts.add(u);
    for (const double u : sign_change_roots<2>(denominator)) cuts.add(u);
    return cuts.where([&](double u) {
        const double sign = value_at<2>(denominator, u) * value_at<2>(start_denominator, u);
        return starts(cell, u) && value_at<4>(beyond, u) * sign > 0.0;
    });
}

}  // namespace overfly
