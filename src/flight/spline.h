#pragma once

#include <span>
#include <vector>

#include "core/geometry.h"
#include "geo/frames.h"

namespace overfly {

// A curve's value and its first two derivatives by time, at one time.
template <class Value>
struct Knot {
    double time_s = 0.0;
    Value value{}, velocity{}, acceleration{};
};

// The quintic between two knots that meets both (Hermite's interpolation). It is a polynomial for all times.
// REQUIRES: from.time_s < to.time_s.
template <class Value>
[[nodiscard]] Value quintic_at(const Knot<Value>& from, const Knot<Value>& to, double time_s);

// A smooth curve through values at given times, a quintic between each two. Made for double and Vector<Ecef>.
//
// GUARANTEES: C2; passes through every value; a span depends on the three values before and the three after it only;
// between two values the curve never runs backward along their chord, and it stands still where the two are equal. So
// a curve of numbers is monotone between two values: it overshoots nowhere, and has its extrema at knots only.
// The values of a parabola are followed exactly where it is monotone, and so are those of a cubic unless its bend
// changes by much from one knot to the next at the ends.
//
// Why monotone: a quintic's Bernstein coefficients, with h the span's length, are
//     b0 = p0, b1 = p0 + h v0/5, b2 = p0 + 2 h v0/5 + h^2 a0/20,  and the same from the other end:
//     b5 = p1, b4 = p1 - h v1/5, b3 = p1 - 2 h v1/5 + h^2 a1/20.
// The derivative's coefficients are 5 (b[k+1] - b[k]) / h, and a polynomial lies within the hull of its coefficients
// (Farin, Curves and Surfaces for CAGD, 5.1-5.3). The derivative's component along the chord is therefore nowhere
// negative if the five differences have none that is: b1 - b0 and b2 - b1 are the concern of one knot alone, and b3 -
// b2 has none if |b2 - b0| + |b5 - b3| <= |p1 - p0|. The last also keeps the control points, hence the curve, within
// the chord's length of the span's ends.
template <class Value>
class Spline {
  public:
    // REQUIRES: as many times as values, at least one; times strictly increasing. One value alone is a constant, two
    // are joined by a straight line.
    Spline(std::span<const double> times_s, std::span<const Value> values);

    // Before the first knot and after the last the outermost quintics go on.
    [[nodiscard]] Value at(double time_s) const;
    [[nodiscard]] const std::vector<Knot<Value>>& knots() const { return knots_; }

  private:
    std::vector<Knot<Value>> knots_;
};

extern template class Spline<double>;
extern template class Spline<Vector<Ecef>>;

}  // namespace overfly
