#include "flight/attitude.h"

#include <cmath>
#include <numbers>

namespace overfly {

Rotation<Scene, Camera> orientation(const Attitude& attitude, const Rotation<Scene, Scene>& local_axes) {
    const double heading = attitude.heading.radians(), pitch = attitude.pitch.radians(), roll = attitude.roll.radians();
    const Vector<Scene> ahead = std::sin(heading) * local_axes.x + std::cos(heading) * local_axes.y;
    const Vector<Scene> level_right = std::cos(heading) * local_axes.x - std::sin(heading) * local_axes.y;
    const Vector<Scene> view = std::cos(pitch) * ahead + std::sin(pitch) * local_axes.z;
    const Vector<Scene> level_down = std::sin(pitch) * ahead - std::cos(pitch) * local_axes.z;
    // Rolling right turns the right wing down.
    return {std::cos(roll) * level_right + std::sin(roll) * level_down,
            std::cos(roll) * level_down - std::sin(roll) * level_right, view};
}

Attitude attitude_towards(Vector<Scene> direction, const Rotation<Scene, Scene>& local_axes) {
    const double east = dot(direction, local_axes.x), north = dot(direction, local_axes.y);
    return {Angle::radians(std::atan2(east, north)),
            Angle::radians(std::atan2(dot(direction, local_axes.z), std::hypot(east, north))), Angle()};
}

Angle nearest_turn(Angle angle, Angle reference) {
    return reference + Angle::radians(std::remainder((angle - reference).radians(), 2.0 * std::numbers::pi));
}

}  // namespace overfly
