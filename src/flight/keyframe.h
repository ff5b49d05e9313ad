#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "core/angle.h"
#include "flight/lens.h"
#include "geo/frames.h"

namespace overfly {

// What a height in a flight document is counted from.
enum class HeightAbove { Ground, SeaLevel, Ellipsoid };

// A place as a flight document gives it: its height still needs the ground or the geoid to become ellipsoidal.
struct FlightPlace {
    Angle lon, lat;
    double height_m = 0.0;
    HeightAbove above = HeightAbove::Ellipsoid;

    friend constexpr bool operator==(const FlightPlace&, const FlightPlace&) = default;
};

// Heading clockwise from north, pitch up from the horizon, roll clockwise as the pilot sees it (right wing down).
// The horizon is that of the ellipsoid at the camera.
struct Attitude {
    Angle heading, pitch, roll;

    friend constexpr bool operator==(const Attitude&, const Attitude&) = default;
};

// The camera keeps `target` in the middle of the picture; roll as in Attitude, about the view.
struct LookAt {
    FlightPlace target;
    Angle roll;

    friend constexpr bool operator==(const LookAt&, const LookAt&) = default;
};

struct Keyframe {
    double time_s = 0.0;
    FlightPlace place;
    std::variant<Attitude, LookAt> aim;
    Lens lens;

    friend constexpr bool operator==(const Keyframe&, const Keyframe&) = default;
};

// What a flight needs to know of the world, handed in by whoever knows it.
struct Surroundings {
    // Ellipsoidal height of the ground, or nothing where there is none.
    std::function<std::optional<double>(Angle lon, Angle lat)> ground_height_m;
    // Ellipsoidal height of sea level.
    std::function<double(Angle lon, Angle lat)> sea_level_m;
    // Distance from a point to the nearest ground in any direction.
    std::function<double(Point<Scene>)> distance_to_ground_m;
};

}  // namespace overfly
