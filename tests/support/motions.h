#pragma once

#include <cmath>

#include "flight/motion.h"

namespace overfly::testing {

// A piece of flight of one second made by hand: from a place, along a velocity, looking along heading and pitch and
// turning by `turn` about the vertical while it lasts; half the field of view has a tangent of 0.577 (60 degrees
// across).
struct HandMotion {
    Point<Scene> from;
    Vector<Scene> velocity;
    double heading_rad = 0.0, pitch_rad = 0.0, turn_rad = 0.0;

    [[nodiscard]] MotionPiece piece() const {
        const auto view_at = [&](double u) {
            const double h = heading_rad + turn_rad * u;
            return Vector<Scene>{std::sin(h) * std::cos(pitch_rad), std::cos(h) * std::cos(pitch_rad),
                                 std::sin(pitch_rad)};
        };
        const auto right_at = [&](double u) {
            const double h = heading_rad + turn_rad * u;
            return 0.577 * Vector<Scene>{std::cos(h), -std::sin(h), 0.0};
        };
        const auto down_at = [&](double u) { return cross(view_at(u), right_at(u)); };
        const auto through = [](const auto& f) {
            const Vector<Scene> a = f(0.0);
            const Vector<Scene> b = f(0.5);
            const Vector<Scene> c = f(1.0);
            return QuadraticVector{a, 4.0 * b - 3.0 * a - c, 2.0 * a + 2.0 * c - 4.0 * b};
        };
        return {{0.0, 1.0},      from, {{}, velocity, {1.0, -2.0, 3.0}}, through(right_at), through(down_at),
                through(view_at)};
    }
};

}  // namespace overfly::testing
