#include "flight/spline.h"

#include <algorithm>
#include <cstddef>
#include <functional>

#include "core/error.h"
#include "flight/knot_derivatives.h"

namespace overfly {

template <class Value>
Value quintic_at(const Knot<Value>& from, const Knot<Value>& to, double time_s) {
    const double h = to.time_s - from.time_s, u = (time_s - from.time_s) / h;
    const Value v = h * from.velocity, a = (h * h) * from.acceleration;
    // What is left at the far end after the first three terms: of value, velocity and acceleration.
    const Value p1 = to.value - from.value - v - 0.5 * a;
    const Value v1 = h * to.velocity - v - a;
    const Value a1 = (h * h) * to.acceleration - a;
    const Value c3 = 10.0 * p1 - 4.0 * v1 + 0.5 * a1;
    const Value c4 = 7.0 * v1 - 15.0 * p1 - a1;
    const Value c5 = 6.0 * p1 - 3.0 * v1 + 0.5 * a1;
    return from.value + u * (v + u * (0.5 * a + u * (c3 + u * (c4 + u * c5))));
}

template <class Value>
Spline<Value>::Spline(std::span<const double> times_s, std::span<const Value> values) {
    check(!times_s.empty() && times_s.size() == values.size(), "a spline has a time for each of its values");
    check(std::adjacent_find(times_s.begin(), times_s.end(), std::greater_equal<>()) == times_s.end(),
          "a spline's times increase");
    const std::vector<KnotDerivatives<Value>> derivatives = knot_derivatives<Value>(times_s, values);
    for (std::size_t i = 0; i < values.size(); ++i)
        knots_.push_back({times_s[i], values[i], derivatives[i].velocity, derivatives[i].acceleration});
}

template <class Value>
Value Spline<Value>::at(double time_s) const {
    if (knots_.size() == 1) return knots_.front().value;
    const auto after = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, time_s,
                                        [](double t, const Knot<Value>& knot) { return t < knot.time_s; });
    return quintic_at(*(after - 1), *after, time_s);
}

template double quintic_at(const Knot<double>&, const Knot<double>&, double);
template class Spline<double>;
template class Spline<Vector<Ecef>>;

}  // namespace overfly
