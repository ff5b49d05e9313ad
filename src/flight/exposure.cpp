#include "flight/exposure.h"

#include <algorithm>
#include <cmath>

namespace overfly {
namespace {

// Openness while the shutter opens, at a part s of the ramp.
double opening(ShutterCurve::Shape shape, double s) {
    return shape == ShutterCurve::Shape::Trapezoid ? s : s * s * (3.0 - 2.0 * s);
}

// Its integral from 0: 1/2 at 1 for both.
double opened(ShutterCurve::Shape shape, double s) {
    return shape == ShutterCurve::Shape::Trapezoid ? 0.5 * s * s : s * s * s * (1.0 - 0.5 * s);
}

// Newton's method from where the cubic alone would be; the function is convex on [0, 1], so it comes from the right.
double ramp_part(ShutterCurve::Shape shape, double area) {
    if (shape == ShutterCurve::Shape::Trapezoid) return std::sqrt(2.0 * area);
    if (area <= 0.0) return 0.0;
    double s = std::min(1.0, std::cbrt(2.0 * area));
    constexpr int kSteps = 8;
    for (int i = 0; i < kSteps; ++i) s -= (opened(shape, s) - area) / opening(shape, s);
    return s;
}

}  // namespace

double ShutterCurve::share_until(double s) const {
    if (s <= 0.0) return 0.0;
    if (s >= 1.0) return 1.0;
    if (is_box()) return s;
    if (s > 0.5) return 1.0 - share_until(1.0 - s);
    return (s < ramp ? ramp * opened(shape, s / ramp) : s - 0.5 * ramp) / (1.0 - ramp);
}

double ShutterCurve::part_until(double share) const {
    if (share <= 0.0) return 0.0;
    if (share >= 1.0) return 1.0;
    if (is_box()) return share;
    if (share > 0.5) return 1.0 - part_until(1.0 - share);
    const double area = share * (1.0 - ramp);
    return area < 0.5 * ramp ? ramp * ramp_part(shape, area / ramp) : area + 0.5 * ramp;
}

double ShutterCurve::openness(double s) const {
    if (s < 0.0 || s > 1.0) return 0.0;
    if (is_box()) return 1.0;
    const double from_end = std::min(s, 1.0 - s);
    return (from_end < ramp ? opening(shape, from_end / ramp) : 1.0) / (1.0 - ramp);
}

}  // namespace overfly
