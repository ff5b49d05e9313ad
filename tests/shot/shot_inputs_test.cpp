#include "shot/shot_inputs.h"

#include <fstream>
#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "config/sample_documents.h"
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
        [](ShotDocument& s) { s.frames.date = parse_local_time("2026-06-21T09:30:00-06:00"); },
        [](ShotDocument& s) { s.frames.date = parse_local_time("2026-06-21T09:30:00-05:00"); },
        [](ShotDocument& s) { s.image.width = 961; },
        [](ShotDocument& s) { s.image.height = 541; },
        [](ShotDocument& s) { s.image.transparent_sky = true; },
        [](ShotDocument& s) { s.shutter.angle = Angle::degrees(90.0); },
        [](ShotDocument& s) { s.shutter.phase = Shutter::Phase::Start; },
        [](ShotDocument& s) { s.shutter.seconds = 0.01; },
        [](ShotDocument& s) { s.shutter.curve.shape = ShutterCurve::Shape::Trapezoid; },
        [](ShotDocument& s) { s.shutter.curve.shape = ShutterCurve::Shape::Smooth; },
        [](ShotDocument& s) {
            s.shutter.curve = {ShutterCurve::Shape::Smooth, 0.5};
        },
        [](ShotDocument& s) {
            s.frames.speeds = {{0.0, 0.5}};
        },
        [](ShotDocument& s) {
            s.frames.speeds = {{1.0, 0.5}, {24.0, 0.25}};
        },
        [](ShotDocument& s) { s.image.filter = FilterKind::Mitchell; },
        [](ShotDocument& s) { s.image.filter_width_px = 1.5; },
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
        [](ShotDocument& s) { s.mesh_pixel_error = 0.25; },
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

// A body of each shape and motion.
std::vector<BodyDocument> sample_bodies(const ShotDocument& shot, const std::filesystem::path& mesh) {
    std::ofstream(mesh) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    BodyPolynomials drift;
    drift.place = {Angle::degrees(-105.52), Angle::degrees(37.6), 100.0, HeightAbove::Ground};
    drift.east_m.coefficients = {1.0, 2.0};
    BodyDocument kite;
    kite.name = "kite";
    kite.shape = std::vector<Polygon>{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    kite.motion = drift;
    BodyDocument plane = kite;
    plane.name = "plane";
    plane.shape = MeshSource{mesh};
    plane.motion = BodyFlight{shot.flight.keyframes, 1.0};
    BodyDocument lake = kite;
    lake.name = "lake";
    lake.shape = Outline{{Angle::degrees(-105.5), Angle::degrees(37.6)},
                         {Angle::degrees(-105.4), Angle::degrees(37.6)},
                         {Angle::degrees(-105.4), Angle::degrees(37.5)}};
    return {kite, plane, lake};
}

TEST(ShotInputs, EverythingAboutBodiesThatChangesPixelsChangesTheHash) {
    const TemporaryFolder folder;
    ShotDocument shot = sample_shot(folder.path());
    shot.bodies = sample_bodies(shot, folder / "a.obj");
    const auto drift = [](ShotDocument& s) -> BodyPolynomials& {
        return std::get<BodyPolynomials>(s.bodies[0].motion);
    };
    const auto flight = [](ShotDocument& s) -> BodyFlight& { return std::get<BodyFlight>(s.bodies[1].motion); };
    const auto mesh = [](ShotDocument& s) -> MeshSource& { return std::get<MeshSource>(s.bodies[1].shape); };
    std::ofstream(folder / "b.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n";
    const std::vector<Change> changes = {
        [](ShotDocument&) {},
        [](ShotDocument& s) { s.bodies.clear(); },
        [](ShotDocument& s) { s.bodies.pop_back(); },
        [](ShotDocument& s) { s.bodies[0].albedo.g = 0.25F; },
        [](ShotDocument& s) { s.bodies[0].mirror = 0.25; },
        [](ShotDocument& s) { s.bodies[1].shadow = false; },
        [](ShotDocument& s) { std::get<std::vector<Polygon>>(s.bodies[0].shape)[0][2].z = 1e-9; },
        [](ShotDocument& s) { std::get<Outline>(s.bodies[2].shape)[0].lon = Angle::degrees(-105.51); },
        [&](ShotDocument& s) { drift(s).place.height_m += 1e-6; },
        [&](ShotDocument& s) { drift(s).east_m.coefficients[1] += 1e-9; },
        [&](ShotDocument& s) { std::swap(drift(s).east_m, drift(s).north_m); },
        [&](ShotDocument& s) { drift(s).up_m.coefficients = {1.0}; },
        [&](ShotDocument& s) { drift(s).heading_deg.coefficients = {1.0}; },
        [&](ShotDocument& s) { drift(s).pitch_deg.coefficients = {1.0}; },
        [&](ShotDocument& s) { drift(s).roll_deg.coefficients = {1.0}; },
        [&](ShotDocument& s) { flight(s).delay_s = 1.5; },
        [&](ShotDocument& s) { flight(s).keyframes[1].place.height_m += 1e-6; },
        [&](ShotDocument& s) { mesh(s).scale = 2.0; },
        [&](ShotDocument& s) { mesh(s).up = UpAxis::Y; },
        [&](ShotDocument& s) { mesh(s).file = folder / "b.obj"; },
        [](ShotDocument& s) { s.sampling.mirror_depth = 2; },
        [](ShotDocument& s) { s.look.sun_shadows = SunShadows::Exact; },
    };
    std::set<std::string> hashes;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        ShotDocument changed = shot;
        changes[i](changed);
        EXPECT_TRUE(hashes.insert(shot_inputs_hash(changed, "scene")).second) << "change " << i;
    }
    std::ofstream(folder / "a.obj") << "v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_TRUE(hashes.insert(shot_inputs_hash(shot, "scene")).second) << "another mesh under the same name";
}

TEST(ShotInputs, NamesOfBodiesAndOfTheirFilesDoNotChangeTheHash) {
    const TemporaryFolder folder;
    ShotDocument shot = sample_shot(folder.path());
    shot.bodies = sample_bodies(shot, folder / "a.obj");
    const std::string hash = shot_inputs_hash(shot, "scene");
    std::filesystem::rename(folder / "a.obj", folder / "renamed.obj");
    std::get<MeshSource>(shot.bodies[1].shape).file = folder / "renamed.obj";
    shot.bodies[0].name = "another";
    shot.bodies[1].flight_file = "elsewhere.yaml";
    EXPECT_EQ(shot_inputs_hash(shot, "scene"), hash);
}

TEST(ShotInputs, EverythingAboutLayersThatChangesFramesChangesTheHash) {
    const TemporaryFolder folder;
    ShotDocument shot = sample_shot(folder.path());
    shot.bodies = sample_bodies(shot, folder / "a.obj");
    shot.layers = {Layer::Normal, Layer::Cryptomatte};
    const std::filesystem::path raster = config_tests::source_folder / "terrain/blanca_peak_utm13n_75m.tif";
    std::filesystem::copy_file(raster, folder / "classes.tif");
    shot.classes = {folder / "classes.tif", 1, {{11, "water"}}};
    const std::vector<Change> changes = {
        [](ShotDocument&) {},
        [](ShotDocument& s) { s.layers = {}; },
        [](ShotDocument& s) { s.layers = {Layer::Normal}; },
        [](ShotDocument& s) { s.layers.add(Layer::Cost); },
        [](ShotDocument& s) { s.output.layer_files = true; },
        [](ShotDocument& s) { s.bodies[0].name = "another"; },
        [](ShotDocument& s) { s.classes.reset(); },
        [](ShotDocument& s) { s.classes->band = 2; },
        [](ShotDocument& s) { s.classes->names[11] = "lake"; },
        [](ShotDocument& s) { s.classes->names[12] = "snow"; },
    };
    std::set<std::string> hashes;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        ShotDocument changed = shot;
        changes[i](changed);
        EXPECT_TRUE(hashes.insert(shot_inputs_hash(changed, "scene")).second) << "change " << i;
    }
    std::ofstream(folder / "classes.tif", std::ios::app) << "more";
    EXPECT_TRUE(hashes.insert(shot_inputs_hash(shot, "scene")).second) << "another raster under the same name";
}

TEST(ShotInputs, NeedTheMeshOfABody) {
    const TemporaryFolder folder;
    ShotDocument shot = sample_shot(folder.path());
    shot.bodies = sample_bodies(shot, folder / "a.obj");
    std::filesystem::remove(folder / "a.obj");
    EXPECT_THROW((void)shot_inputs_hash(shot, "scene"), UserError);
}

TEST(ShotInputs, HoldWhatColoursLose) {
    const TemporaryFolder folder;
    const ShotDocument shot = sample_shot(folder.path());
    ShotDocument lossy = shot, coarse = shot;
    lossy.output.storage.beauty = Compression::Dwaa;
    coarse.output.storage = {.beauty = Compression::Dwaa, .quality = 90.0};
    EXPECT_NE(shot_inputs_hash(lossy, "scene"), shot_inputs_hash(shot, "scene"));
    EXPECT_NE(shot_inputs_hash(coarse, "scene"), shot_inputs_hash(lossy, "scene"));
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
        [](ShotDocument& s) { s.output.layer_files = true; },  // of no layers
        [](ShotDocument& s) { s.classes = {"no.tif"}; },       // that nothing shows
        [](ShotDocument& s) { s.output.preview.burn_in.frame = true; },
        [](ShotDocument& s) { s.output.storage = {.beauty = Compression::Piz, .data = Compression::Zips}; },
        [](ShotDocument& s) { s.output.storage.quality = 60.0; },  // of a compression that isn't used
        [](ShotDocument& s) { s.sampling.samples = 99; },          // of the tracer that isn't used
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        ShotDocument changed = shot;
        changes[i](changed);
        EXPECT_EQ(shot_inputs_hash(changed, "scene"), shot_inputs_hash(shot, "scene")) << "change " << i;
    }
}

}  // namespace
}  // namespace overfly
