#pragma once

#include <string>

#include <gtest/gtest.h>

#include "config/documents.h"
#include "config/read.h"
#include "io/temporary_folder.h"

namespace overfly {

// A shot over the terrain that ships: two seconds of level flight, with its output in `folder`.
inline ShotDocument sample_shot(const std::filesystem::path& folder) {
    const auto keyframe = [](double time_s, double lon_deg) {
        Keyframe k;
        k.time_s = time_s;
        k.place = {Angle::degrees(lon_deg), Angle::degrees(37.6), 5000.0, HeightAbove::SeaLevel};
        k.aim = Attitude{Angle::degrees(140.0), Angle::degrees(-12.0), {}};
        return k;
    };
    ShotDocument shot;
    shot.file = folder / "sample.yaml";
    shot.terrain = read_terrain_document(OVERFLY_SOURCE_DIR "/terrain/blanca_peak.yaml");
    shot.flight.keyframes = {keyframe(0.0, -105.53), keyframe(2.0, -105.51)};
    shot.output.folder = folder / "frames";
    shot.output.name = "sample";
    return shot;
}

}  // namespace overfly
