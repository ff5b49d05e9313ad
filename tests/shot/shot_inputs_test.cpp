#include "shot/shot_inputs.h"

#include <fstream>
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "shot/sample_shot.h"

namespace overfly {
namespace {

using Change = std::function<void(ShotDocument&)>;

TEST(ShotInputs, EverythingThatChangesPixelsChangesTheHash) {
    const TemporaryFolder folder;
    const ShotDocument shot = sample_shot(folder.path());
    std::ofstream(folder / "ramp.txt") << "0 0 0 0\n5000 255 255 255\n";
    const std::vector<Change> changes = {
        [](ShotDocument&) {},
        [](ShotDocument& s) { s.flight.keyframes[1].time_s += 1e-9; },
        [](ShotDocument& s) {
            s.flight.keyframes[1].place.lon = s.flight.keyframes[1].place.lon + Angle::degrees(1e-9);
        },
        [](ShotDocument& s) { s.flight.keyframes[0].place.height_m += 1e-6; },
        [](ShotDocument& s) { s.flight.keyframes[0].place.above = HeightAbove::Ellipsoid; },
        [](ShotDocument& s) { std::get<Attitude>(s.flight.keyframes[0].aim).roll = Angle::degrees(1.0); },
        [](ShotDocument& s) {
            s.flight.keyframes[0].aim = LookAt{s.flight.keyframes[1].place, {}};
        },
        [](ShotDocument& s) { s.flight.keyframes[0].lens.horizontal_fov = Angle::degrees(61.0); },
        [](ShotDocument& s) { s.flight.keyframes.pop_back(); },
        [](ShotDocument& s) { s.frames.first = 2; },
        [](ShotDocument& s) {
            s.frames.rate = {25, 1};
        },
        [](ShotDocument& s) { s.frames.start_s = 0.5; },
        [](ShotDocument& s) { s.image.width = 961; },
        [](ShotDocument& s) { s.image.height = 541; },
        [](ShotDocument& s) { s.image.transparent_sky = true; },
        [](ShotDocument& s) { s.shutter.angle = Angle::degrees(90.0); },
        [](ShotDocument& s) { s.shutter.phase = Shutter::Phase::Start; },
        [](ShotDocument& s) { s.sampling.tracer = TracerKind::Discrete; },
        [](ShotDocument& s) { s.sampling.lines = 5; },
        [](ShotDocument& s) { s.look.look.sun_azimuth = Angle::degrees(90.0); },
        [](ShotDocument& s) { s.look.look.sun_elevation = Angle::degrees(20.0); },
        [](ShotDocument& s) { s.look.look.sun_strength = 1.5; },
        [](ShotDocument& s) { s.look.look.sky_strength = 1.5; },
        [](ShotDocument& s) { s.look.look.visibility_m = 10'000.0; },
        [](ShotDocument& s) { s.look.look.exposure_stops = 1.0; },
        [&](ShotDocument& s) { s.look.colours = folder / "ramp.txt"; },
        [](ShotDocument& s) { s.motion_bound_px = 0.02; },
    };
    std::set<std::string> hashes;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        ShotDocument changed = shot;
        changes[i](changed);
        EXPECT_TRUE(hashes.insert(shot_inputs_hash(changed, "scene")).second) << "change " << i;
    }
    EXPECT_TRUE(hashes.insert(shot_inputs_hash(shot, "another scene")).second);
    ShotDocument coloured = shot;
    coloured.look.colours = folder / "ramp.txt";
    std::ofstream(folder / "ramp.txt") << "0 9 9 9\n5000 255 255 255\n";
    EXPECT_TRUE(hashes.insert(shot_inputs_hash(coloured, "scene")).second) << "other colours under the same name";
}

TEST(ShotInputs, NamesAndChoicesDoNotChangeTheHash) {
    const TemporaryFolder folder;
    const ShotDocument shot = sample_shot(folder.path());
    const std::vector<Change> changes = {
        [](ShotDocument& s) { s.file = "renamed.yaml"; },
        [](ShotDocument& s) { s.terrain.file = "renamed.yaml"; },
        [](ShotDocument& s) { s.output.folder = "elsewhere"; },
        [](ShotDocument& s) { s.output.name = "another"; },
        [](ShotDocument& s) { s.output.movie = false; },
        [](ShotDocument& s) { s.sampling.samples = 99; },  // of the tracer that isn't used
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        ShotDocument changed = shot;
        changes[i](changed);
        EXPECT_EQ(shot_inputs_hash(changed, "scene"), shot_inputs_hash(shot, "scene")) << "change " << i;
    }
}

}  // namespace
}  // namespace overfly
