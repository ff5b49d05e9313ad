#include "flight/spline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace overfly {
namespace {

using Numbers = std::vector<double>;

Numbers evenly(std::size_t count, double step) {
    Numbers times;
    for (std::size_t i = 0; i < count; ++i) times.push_back(step * static_cast<double>(i));
    return times;
}

// Calls check(span, time) at `count` times of every span of the knots.
template <class Check>
void for_each_time(const Numbers& times, int count, Check check) {
    for (std::size_t i = 0; i + 1 < times.size(); ++i)
        for (int k = 0; k <= count; ++k) check(i, times[i] + (times[i + 1] - times[i]) * k / count);
}

// The cubic C2 spline with no curvature at its ends, evaluated by the second derivatives of the tridiagonal system.
double natural_cubic(const Numbers& t, const Numbers& p, double time) {
    const std::size_t n = t.size();
    Numbers diagonal(n, 1.0), right(n, 0.0), upper(n, 0.0), second(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double h0 = t[i] - t[i - 1], h1 = t[i + 1] - t[i];
        diagonal[i] = 2.0 * (h0 + h1) - h0 * upper[i - 1];
        upper[i] = h1 / diagonal[i];
        right[i] = (6.0 * ((p[i + 1] - p[i]) / h1 - (p[i] - p[i - 1]) / h0) - h0 * right[i - 1]) / diagonal[i];
    }
    for (std::size_t i = n - 1; i-- > 1;) second[i] = right[i] - upper[i] * second[i + 1];
    std::size_t i = 0;
    while (i + 2 < n && time > t[i + 1]) ++i;
    const double h = t[i + 1] - t[i], a = (t[i + 1] - time) / h, b = (time - t[i]) / h;
    return a * p[i] + b * p[i + 1] + ((a * a * a - a) * second[i] + (b * b * b - b) * second[i + 1]) * h * h / 6.0;
}

TEST(Spline, MeetsItsValuesAndOneOrTwoAreAConstantAndALine) {
    const Numbers one{3.0}, at{5.0};
    EXPECT_EQ(Spline<double>(at, one).at(-100.0), 3.0);
    const Numbers times{1.0, 3.0}, values{10.0, 20.0};
    const Spline<double> line(times, values);
    for (const double t : {1.0, 1.5, 2.0, 3.0, 4.0}) EXPECT_NEAR(line.at(t), 10.0 + 5.0 * (t - 1.0), 1e-12);
}

TEST(Spline, FollowsAParabolaThatDoesNotTurnBack) {
    // From rest at a steady acceleration: what an ease-in is written as.
    const Numbers times = evenly(6, 1.0);
    Numbers values;
    for (const double t : times) values.push_back(t * t);
    const Spline<double> spline(times, values);
    for_each_time(times, 10, [&](std::size_t, double t) { EXPECT_NEAR(spline.at(t), t * t, 1e-12); });
}

TEST(Spline, FollowsACubicAtUnevenTimes) {
    const Numbers times{0.0, 1.0, 1.5, 3.0, 4.0, 4.7, 6.0};
    const auto cubic = [](double t) { return 40.0 * t + 3.0 * t * t + 0.1 * t * t * t; };
    Numbers values;
    for (const double t : times) values.push_back(cubic(t));
    const Spline<double> spline(times, values);
    for_each_time(times, 10, [&](std::size_t, double t) { EXPECT_NEAR(spline.at(t), cubic(t), 1e-10); });
}

TEST(Spline, IsMonotoneBetweenRandomValuesWhereTheNaturalCubicIsNot) {
    constexpr unsigned kSeed = 7;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> step(0.05, 3.0), value(-100.0, 100.0);
    double cubic_overshoot = 0.0;
    for (int flight = 0; flight < 200; ++flight) {
        Numbers times{0.0}, values{value(random)};
        for (int i = 0; i < 8; ++i) {
            times.push_back(times.back() + step(random));
            values.push_back(i % 3 == 2 ? values.back() : value(random));
        }
        const Spline<double> spline(times, values);
        double last = values.front();
        for_each_time(times, 50, [&](std::size_t i, double t) {
            const double now = spline.at(t), chord = values[i + 1] - values[i];
            if (t > times[i]) {
                EXPECT_GE((now - last) * (chord < 0.0 ? -1.0 : 1.0), -1e-10) << "seed " << kSeed;
            }
            if (chord == 0.0) {
                EXPECT_EQ(now, values[i]);
            }
            last = now;
            const auto [low, high] = std::minmax(values[i], values[i + 1]);
            cubic_overshoot = std::max(
                {cubic_overshoot, low - natural_cubic(times, values, t), natural_cubic(times, values, t) - high});
        });
    }
    EXPECT_GT(cubic_overshoot, 10.0);  // of values within 200
}

TEST(Spline, HasTwoContinuousDerivatives) {
    const Numbers times{0.0, 0.5, 2.0, 3.0, 3.2, 5.0}, values{0.0, 3.0, 4.0, 9.0, 10.0, -5.0};
    const Spline<double> spline(times, values);
    const auto& knots = spline.knots();
    for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
        constexpr double kStep_s = 1e-4;
        const auto side = [&](std::size_t from, double sign) {
            const auto f = [&](int k) {
                return quintic_at(knots[from], knots[from + 1], times[i] + sign * k * kStep_s);
            };
            const double velocity = sign * (-11.0 * f(0) + 18.0 * f(1) - 9.0 * f(2) + 2.0 * f(3)) / (6.0 * kStep_s);
            const double acceleration = (2.0 * f(0) - 5.0 * f(1) + 4.0 * f(2) - f(3)) / (kStep_s * kStep_s);
            return std::pair(velocity, acceleration);
        };
        const auto before = side(i - 1, -1.0), after = side(i, 1.0);
        EXPECT_NEAR(before.first, after.first, 1e-6);
        EXPECT_NEAR(before.second, after.second, 5e-3);
        EXPECT_NEAR(after.second, knots[i].acceleration, 5e-3);
    }
}

struct Ripple {
    double slowest = 1e9, fastest = 0.0, off_circle = 0.0;
};

// How evenly and truly the spline goes round a unit circle of which it is given a point every so many degrees; away
// from the ends, where the neighbours are on one side only, if `inside`.
Ripple circle_ripple(double step_deg, bool inside) {
    const Numbers times = evenly(12, step_deg * std::numbers::pi / 180.0);
    std::vector<Vector<Ecef>> values;
    for (const double t : times) values.push_back({std::cos(t), std::sin(t), 0.0});
    const Spline<Vector<Ecef>> spline(times, values);
    Ripple ripple;
    for_each_time(times, 40, [&](std::size_t i, double t) {
        if (inside && (i < 2 || i + 4 > times.size() - 1)) return;
        constexpr double kStep = 1e-5;
        const double speed = length(spline.at(t + kStep) - spline.at(t - kStep)) / (2.0 * kStep);
        ripple.slowest = std::min(ripple.slowest, speed);
        ripple.fastest = std::max(ripple.fastest, speed);
        ripple.off_circle = std::max(ripple.off_circle, std::abs(length(spline.at(t)) - 1.0));
    });
    return ripple;
}

TEST(Spline, GoesRoundACircleAtASteadySpeed) {
    struct Case {
        double step_deg, ripple, off_circle, ripple_at_ends;
    };
    for (const Case c : {Case{15.0, 0.0003, 1.1e-5, 0.002}, Case{30.0, 0.0025, 1e-4, 0.021},
                         Case{45.0, 0.013, 3e-4, 0.1}, Case{60.0, 0.04, 4e-3, 0.25}}) {
        const Ripple inside = circle_ripple(c.step_deg, true), all = circle_ripple(c.step_deg, false);
        EXPECT_GT(inside.slowest, 1.0 - c.ripple) << c.step_deg;
        EXPECT_LT(inside.fastest, 1.0 + c.ripple) << c.step_deg;
        EXPECT_LT(inside.off_circle, c.off_circle) << c.step_deg;
        EXPECT_GT(all.slowest, 1.0 - c.ripple_at_ends) << c.step_deg;
        EXPECT_LT(all.fastest, 1.0 + c.ripple_at_ends) << c.step_deg;
    }
}

TEST(Spline, NeverRunsBackwardAlongAChordOrFarFromIt) {
    constexpr unsigned kSeed = 11;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> step(0.05, 3.0), value(-1.0, 1.0);
    for (int flight = 0; flight < 300; ++flight) {
        Numbers times{0.0};
        std::vector<Vector<Ecef>> values{{0, 0, 0}};
        for (int i = 0; i < 8; ++i) {
            times.push_back(times.back() + step(random));
            const double scale = i % 3 == 0 ? 1e-6 : 1.0;  // near standstill
            values.push_back(values.back() + scale * Vector<Ecef>{value(random), value(random), 0.1 * value(random)});
        }
        const Spline<Vector<Ecef>> spline(times, values);
        Vector<Ecef> last = values.front();
        for_each_time(times, 50, [&](std::size_t i, double t) {
            const Vector<Ecef> now = spline.at(t), chord = values[i + 1] - values[i];
            if (t > times[i]) {
                EXPECT_GE(dot(now - last, chord), -1e-14) << "seed " << kSeed;
            }
            EXPECT_LE(std::min(length(now - values[i]), length(now - values[i + 1])), (1.0 + 1e-9) * length(chord));
            last = now;
        });
    }
}

TEST(Spline, StandsStillBetweenEqualPlaces) {
    const Numbers times = evenly(6, 1.0);
    const std::vector<Vector<Ecef>> values{{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {2, 1, 0}, {2, 5, 0}, {3, 9, 0}};
    const Spline<Vector<Ecef>> spline(times, values);
    for (double t = 2.0; t <= 3.0; t += 0.01) EXPECT_EQ(spline.at(t), values[2]);
}

TEST(Spline, LeavesSpansAloneThatAreFarFromAChange) {
    Numbers times, values;
    for (int i = 0; i < 14; ++i) {
        times.push_back(i + 0.3 * std::sin(i));
        values.push_back(std::sin(2.3 * i) + 0.4 * i);
    }
    const Spline<double> before(times, values);
    constexpr std::size_t kChanged = 7;
    values[kChanged] += 5.0;
    const Spline<double> after(times, values);
    bool is_any_changed = false;
    for_each_time(times, 10, [&](std::size_t i, double t) {
        const bool is_near = i + 3 >= kChanged && i <= kChanged + 2;
        if (!is_near && t < times[i + 1]) {
            EXPECT_EQ(before.at(t), after.at(t)) << "span " << i;
        }
        is_any_changed = is_any_changed || before.at(t) != after.at(t);
    });
    EXPECT_TRUE(is_any_changed);
}

TEST(Spline, DoesNotSwingBeforeACorner) {
    const Numbers times = evenly(7, 1.0);
    const std::vector<Vector<Ecef>> values{{-3, 0, 0}, {-2, 0, 0}, {-1, 0, 0}, {0, 0, 0},
                                           {0, 1, 0},  {0, 2, 0},  {0, 3, 0}};
    const Spline<Vector<Ecef>> spline(times, values);
    for (double t = 0.0; t < 2.0; t += 0.01) EXPECT_EQ(spline.at(t).y, 0.0);
    // The corner itself is taken in a bend that stays close.
    for (double t = 2.0; t < 4.0; t += 0.01) EXPECT_LT(std::max(spline.at(t).x, -spline.at(t).y), 0.09);
}

}  // namespace
}  // namespace overfly
