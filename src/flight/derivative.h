#pragma once

namespace overfly {

template <class Value>
struct ValueAndRates {
    Value value{}, velocity{}, acceleration{};
};

// A function of time and its first two derivatives at one time, by central differences of fourth order (Abramowitz and
// Stegun 25.3.6, 25.3.24). The function must answer up to two steps before and after.
template <class Function>
[[nodiscard]] auto derivatives_at(const Function& f, double time_s, double step_s) {
    const auto m2 = f(time_s - 2.0 * step_s), m1 = f(time_s - step_s), centre = f(time_s), p1 = f(time_s + step_s),
               p2 = f(time_s + 2.0 * step_s);
    using Value = decltype(f(time_s));
    return ValueAndRates<Value>{centre, (8.0 * (p1 - m1) - (p2 - m2)) / (12.0 * step_s),
                                (16.0 * (p1 + m1) - (p2 + m2) - 30.0 * centre) / (12.0 * step_s * step_s)};
}

}  // namespace overfly
