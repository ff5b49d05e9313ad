#pragma once

#include <optional>

#include "flight/camera_path.h"

namespace overfly {

struct Extreme {
    double value = 0.0;
    double time_s = 0.0;
};

// Where the camera is nearest above (or deepest below) the ground.
struct LowestClearance {
    double clearance_m = 0.0;  // negative below the ground
    double time_s = 0.0;
    Angle lon, lat;
};

// A flight in the numbers that people judge it by. Speeds and rates are those against the ground, the horizon's own
// turning as the camera follows the Earth included.
struct PathReport {
    double duration_s = 0.0;
    double length_m = 0.0;  // along the path, through the air
    double climb_m = 0.0;   // all that goes up; what goes down does not count
    Extreme slowest_m_per_s, fastest_m_per_s;
    double mean_m_per_s = 0.0;
    Extreme hardest_g;  // acceleration, without gravity

    Extreme fastest_turn_deg_per_s;  // of the camera about whatever axis
    // Of the angles, one by one. Near straight down heading and roll are about the same axis, and may be fast in
    // opposite directions where the camera hardly turns.
    Extreme fastest_heading_deg_per_s, fastest_pitch_deg_per_s, fastest_roll_deg_per_s;

    std::optional<LowestClearance> lowest;  // none: no ground under any sample
    double off_terrain_share = 0.0;         // of the time, with no ground under the camera
    [[nodiscard]] bool goes_below_ground() const { return lowest && lowest->clearance_m < 0.0; }
};

// Samples the path, both ends included. Rates are central differences. The length is that of the chords, short by about
// (turn per sample)^2 / 24 of itself, turn in radians. The lowest clearance is refined between samples, as far as the
// ground between two samples has one hollow: sample so that a step is no longer than a post of the terrain.
// REQUIRES: samples_per_second > 0.
[[nodiscard]] PathReport report_path(const CameraPath& path, const Surroundings& surroundings,
                                     double samples_per_second);

}  // namespace overfly
