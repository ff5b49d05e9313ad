#include "flight/knot_derivatives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace overfly {
namespace {

double inner(double a, double b) { return a * b; }
double inner(Vector<Ecef> a, Vector<Ecef> b) { return dot(a, b); }

template <class Value>
double magnitude(Value a) {
    return std::sqrt(inner(a, a));
}

// The unit vector of a, or zero for zero.
template <class Value>
Value direction(Value a) {
    const double size = magnitude(a);
    return size > 0.0 ? a / size : Value{};
}

template <class Value>
class Estimator {
  public:
    Estimator(std::span<const double> times_s, std::span<const Value> values)
        : t_(times_s), d1_(divided(values, 1)), d2_(divided<Value>(d1_, 2)), d3_(divided<Value>(d2_, 3)) {}

    std::vector<KnotDerivatives<Value>> derivatives() const {
        if (d1_.empty()) return std::vector<KnotDerivatives<Value>>(1);
        std::vector<KnotDerivatives<Value>> coarse(t_.size()), fine(t_.size());
        for (std::size_t i = 0; i < t_.size(); ++i) {
            coarse[i] = forward(i, forward_velocity(i), parabola(i));
            fine[i] = forward(i, coarse[i].velocity, cubic(i));
        }
        shorten(coarse, fine);
        return fine;
    }

  private:
    // Newton's divided differences of one order from those of the order below.
    template <class V>
    std::vector<V> divided(std::span<const V> below, std::size_t order) const {
        std::vector<V> result;
        for (std::size_t i = 0; i + 1 < below.size(); ++i)
            result.push_back((below[i + 1] - below[i]) / (t_[i + order] - t_[i]));
        return result;
    }
    double before_s(std::size_t i) const { return t_[i] - t_[i - 1]; }
    double after_s(std::size_t i) const { return t_[i + 1] - t_[i]; }
    bool is_first(std::size_t i) const { return i == 0; }
    bool is_last(std::size_t i) const { return i + 1 == t_.size(); }
    // First of the three knots whose parabola is knot i's.
    std::size_t parabola_start(std::size_t i) const { return std::clamp<std::size_t>(i, 1, t_.size() - 2) - 1; }

    KnotDerivatives<Value> parabola(std::size_t i) const {
        if (d2_.empty()) return {d1_[0], {}};
        const std::size_t j = parabola_start(i);
        return {d1_[j] + ((t_[i] - t_[j]) + (t_[i] - t_[j + 1])) * d2_[j], 2.0 * d2_[j]};
    }

    // Newton's next term: `third` times (t - t_j)(t - t_j+1)(t - t_j+2), differentiated at knot i.
    KnotDerivatives<Value> cubic(std::size_t i) const {
        KnotDerivatives<Value> result = parabola(i);
        if (d3_.empty()) return result;
        const std::size_t j = parabola_start(i);
        const double x0 = t_[i] - t_[j], x1 = t_[i] - t_[j + 1], x2 = t_[i] - t_[j + 2];
        const Value third = third_difference(i);
        result.velocity = result.velocity + (x0 * x1 + x0 * x2 + x1 * x2) * third;
        result.acceleration = result.acceleration + (2.0 * (x0 + x1 + x2)) * third;
        return result;
    }

    // The third difference at a knot as far as there is one: inside, the mean of the cubics on either side (weighted
    // as the quartic through five knots does) but at most twice the smaller; near an end, where there is one cubic
    // only, no more than 1.5 times what the outermost parabola bends. On a circle both leave it whole up to 80 degrees
    // a knot.
    Value third_difference(std::size_t i) const {
        if (i >= 2 && i + 2 < t_.size()) {
            const Value left = d3_[i - 2], right = d3_[i - 1];
            const Value mean = left + ((t_[i] - t_[i - 2]) / (t_[i + 2] - t_[i - 2])) * (right - left);
            return capped(mean, 2.0 * std::min(magnitude(left), magnitude(right)));
        }
        const bool at_begin = i < 2;
        const std::size_t j = at_begin ? 0 : d3_.size() - 1;
        const Value bend = at_begin ? d2_.front() : d2_.back();
        return capped(d3_[j], 1.5 * magnitude(bend) / (t_[j + 3] - t_[j]));
    }

    static Value capped(Value a, double most) {
        const double size = magnitude(a);
        return size > most ? (most / size) * a : a;
    }

    // A velocity that is backward along neither chord: the parabola's, with its two parts cut where they point against
    // each other by more than they are worth.
    Value forward_velocity(std::size_t i) const {
        if (is_first(i) || is_last(i)) return is_first(i) ? d1_.front() : d1_.back();
        const Value in = direction(d1_[i - 1]), out = direction(d1_[i]);
        const double share_s = before_s(i) + after_s(i);
        const double a = magnitude(d1_[i - 1]) * after_s(i) / share_s, b = magnitude(d1_[i]) * before_s(i) / share_s;
        const double against = -inner(in, out);
        if (against <= 0.0) return a * in + b * out;
        return std::min(a, b / against) * in + std::min(b, a / against) * out;
    }

    // As much of `wanted` as points forward along both chords. REQUIRES: `velocity` does.
    KnotDerivatives<Value> forward(std::size_t i, Value velocity, const KnotDerivatives<Value>& wanted) const {
        const Value in = is_first(i) ? Value{} : direction(d1_[i - 1]);
        const Value out = is_last(i) ? Value{} : direction(d1_[i]);
        const Value step = wanted.velocity - velocity;
        const double turn = std::min(share_above(inner(velocity, in), inner(step, in)),
                                     share_above(inner(velocity, out), inner(step, out)));
        KnotDerivatives<Value> result{velocity + turn * step, wanted.acceleration};
        // b2 - b1 and b4 - b3: 4 v + h a >= 0 where the knot begins a span, 4 v - h a >= 0 where it ends one.
        double kept = 1.0;
        if (!is_first(i))
            kept = std::min(
                kept, share_above(4.0 * inner(result.velocity, in), -before_s(i) * inner(wanted.acceleration, in)));
        if (!is_last(i))
            kept = std::min(
                kept, share_above(4.0 * inner(result.velocity, out), after_s(i) * inner(wanted.acceleration, out)));
        result.acceleration = kept * wanted.acceleration;
        return result;
    }

    // The largest share s of [0, 1] with start + s * step >= 0, for a start that is not negative but for rounding.
    static double share_above(double start, double step) {
        return start + step >= 0.0 ? 1.0 : std::clamp(start / -step, 0.0, 1.0);
    }

    // How far the knot's control points are from it: |b2 - b0|, or |b1 - b0| where that is more.
    static double reach(const KnotDerivatives<Value>& at, double span_s, double sign) {
        const Value first = (span_s / 5.0) * at.velocity;
        return std::max(magnitude(first), magnitude(2.0 * first + (sign * span_s * span_s / 20.0) * at.acceleration));
    }

    // What of a chord each of its ends may reach. Chosen by the coarse derivatives: slack is shared evenly, want is
    // first cut from the end that takes more than half.
    static std::array<double, 2> shares(double chord, double from, double to) {
        double first = 0.5 * (chord + from - to);
        if (from + to > chord) first = from <= 0.5 * chord ? from : std::max(0.5 * chord, chord - to);
        return {first, chord - first};
    }

    void shorten(const std::vector<KnotDerivatives<Value>>& coarse, std::vector<KnotDerivatives<Value>>& fine) const {
        std::vector<double> scale(fine.size(), 1.0);
        const auto limit = [&](std::size_t i, double allowed, double wanted) {
            if (wanted > allowed) scale[i] = std::min(scale[i], allowed / wanted);
        };
        for (std::size_t i = 0; i + 1 < fine.size(); ++i) {
            const double span_s = after_s(i);
            const auto [from, to] =
                shares(span_s * magnitude(d1_[i]), reach(coarse[i], span_s, 1.0), reach(coarse[i + 1], span_s, -1.0));
            limit(i, from, reach(fine[i], span_s, 1.0));
            limit(i + 1, to, reach(fine[i + 1], span_s, -1.0));
        }
        for (std::size_t i = 0; i < fine.size(); ++i)
            fine[i] = {scale[i] * fine[i].velocity, scale[i] * fine[i].acceleration};
    }

    std::span<const double> t_;
    std::vector<Value> d1_, d2_, d3_;
};

}  // namespace

template <class Value>
std::vector<KnotDerivatives<Value>> knot_derivatives(std::span<const double> times_s, std::span<const Value> values) {
    return Estimator<Value>(times_s, values).derivatives();
}

template std::vector<KnotDerivatives<double>> knot_derivatives(std::span<const double>, std::span<const double>);
template std::vector<KnotDerivatives<Vector<Ecef>>> knot_derivatives(std::span<const double>,
                                                                     std::span<const Vector<Ecef>>);

}  // namespace overfly
