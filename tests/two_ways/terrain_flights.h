#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/documents.h"
#include "shot/stage.h"

namespace overfly::testing {

// A flight over any terrain, in shares of its extent: places by share from west and from south, heights above the
// ground and speeds in shares of its width.
struct ShareFlight {
    struct Key {
        double time_s, east, north, height;
        Attitude attitude;
    };
    std::vector<Key> keys;
};

inline Attitude attitude(double heading_deg, double pitch_deg, double roll_deg) {
    return {Angle::degrees(heading_deg), Angle::degrees(pitch_deg), Angle::degrees(roll_deg)};
}

// Level over the ground, and a dive with a fast pan and a bank.
inline ShareFlight level_flight() {
    return {{{0.0, 0.35, 0.30, 0.02, attitude(20, -20, 0)},
             {1.0, 0.42, 0.42, 0.02, attitude(24, -18, 2)},
             {2.0, 0.50, 0.55, 0.02, attitude(20, -20, 0)}}};
}
inline ShareFlight diving_flight() {
    return {{{0.0, 0.60, 0.65, 0.12, attitude(200, -50, 0)},
             {1.0, 0.55, 0.58, 0.04, attitude(250, -30, 30)},
             {2.0, 0.48, 0.55, 0.015, attitude(330, -8, -10)}}};
}

inline FlightDocument flight_over(const ElevationReport& report, const ShareFlight& flight) {
    const GeographicExtent& e = report.extent;
    const double width_m = geodesic_length_m({Angle::degrees(e.west_deg), Angle::degrees(e.south_deg), 0.0},
                                             {Angle::degrees(e.east_deg), Angle::degrees(e.south_deg), 0.0});
    FlightDocument document;
    for (const ShareFlight::Key& key : flight.keys) {
        Keyframe k;
        k.time_s = key.time_s;
        k.place = {Angle::degrees(e.west_deg + key.east * (e.east_deg - e.west_deg)),
                   Angle::degrees(e.south_deg + key.north * (e.north_deg - e.south_deg)), key.height * width_m,
                   HeightAbove::Ground};
        k.aim = key.attitude;
        document.keyframes.push_back(k);
    }
    return document;
}

inline TerrainDocument terrain_of(const std::filesystem::path& dem) {
    TerrainDocument document;
    document.source.dem = {dem};
    document.source.vertical_datum = VerticalDatum::Egm96;
    return document;
}

// A fresh stage each time: nothing is taken from a cache.
inline PreparedTerrain prepared(const std::filesystem::path& dem) {
    return prepare_terrain(terrain_of(dem),
                           std::filesystem::path(::testing::TempDir()) / "overfly-no-cache" / dem.filename());
}

inline Motion motion_over(const FlightDocument& flight, const Stage& stage, MotionOptions options = {}) {
    const CameraPath path = make_path(flight, stage);
    return fit_motion(path, path.times(), stage.surroundings(), options);
}

}  // namespace overfly::testing
