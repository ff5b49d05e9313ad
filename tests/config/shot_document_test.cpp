#include <gtest/gtest.h>

#include "config/read.h"
#include "config/sample_documents.h"

namespace overfly {
namespace {

using namespace config_tests;

TEST(ReadShotDocument, ReadsEveryKey) {
    const ShotDocument shot = read_shot_document(good_folder / "shot.yaml");
    EXPECT_EQ(shot.terrain.file, good_folder / "terrain.yaml");
    EXPECT_EQ(shot.terrain.source, read_terrain_document(good_folder / "terrain.yaml").source);
    EXPECT_EQ(shot.flight.keyframes, read_flight_document(good_folder / "flight.yaml").keyframes);
    EXPECT_EQ(shot.frames.first, 101);
    EXPECT_EQ(shot.frames.count, 48);
    EXPECT_EQ(shot.frames.rate, (FrameRate{24000, 1001}));
    EXPECT_EQ(shot.frames.start_s, 0.5);
    EXPECT_EQ(shot.frames.speeds, (std::vector<FlightSpeed>{{110.0, 2.0}, {130.5, 0.25}}));
    ASSERT_TRUE(shot.frames.date);
    EXPECT_EQ(iso_text(*shot.frames.date), "2026-06-21T09:30:00-06:00");
    EXPECT_EQ(shot.image.width, 640);
    EXPECT_EQ(shot.image.height, 360);
    EXPECT_TRUE(shot.image.transparent_sky);
    EXPECT_EQ(shot.image.filter, FilterKind::Mitchell);
    EXPECT_EQ(shot.image.filter_width_px, 3.5);
    EXPECT_EQ(shot.shutter,
              (Shutter{Angle::degrees(270), Shutter::Phase::Start, {}, {ShutterCurve::Shape::Trapezoid, 0.1}}));
    EXPECT_EQ(shot.sampling.tracer, TracerKind::Discrete);
    EXPECT_EQ(shot.sampling.lines, 8);
    EXPECT_EQ(shot.sampling.samples, 128);
    EXPECT_EQ(shot.sampling.mirror_depth, 3);
    EXPECT_EQ(shot.look.sun_shadows, SunShadows::Exact);
    EXPECT_EQ(shot.bodies.size(), 4U);  // bodies_test.cpp
    EXPECT_EQ(shot.look.colours, good_folder / "shot.yaml");
    const Look look{.sun_azimuth = Angle::degrees(120),
                    .sun_elevation = Angle::degrees(20),
                    .sun_strength = 0.9,
                    .sky_strength = 1.1,
                    .visibility_m = 80'000.0,
                    .exposure_stops = -0.5};
    EXPECT_EQ(shot.look.look, look);
    EXPECT_EQ(shot.output.folder, good_folder / "frames");
    EXPECT_EQ(shot.output.name, "blanca");
    EXPECT_FALSE(shot.output.contact_sheet);
    EXPECT_FALSE(shot.output.movie);
    EXPECT_EQ(shot.output.storage,
              (FrameStorage{.beauty = Compression::Dwaa, .data = Compression::Piz, .quality = 60.0}));
    EXPECT_EQ(shot.output.preview.burn_in, (BurnIn{.frame = true, .place = false, .time = true}));
    const ViewChoice view{
        .config = good_folder / "shot.yaml", .colour_space = "linear", .display = "Monitor", .view = "Film"};
    EXPECT_EQ(shot.output.preview.view, view);
    EXPECT_TRUE(shot.output.layer_files);
    LayerSet layers = *layers_named("geo");
    layers.add({Layer::Normal, Layer::Position, Layer::Cryptomatte});
    EXPECT_EQ(shot.layers, layers);
    ASSERT_TRUE(shot.classes);
    EXPECT_EQ(shot.classes->raster, good_folder / "shot.yaml");
    EXPECT_EQ(shot.classes->band, 2);
    EXPECT_EQ(shot.classes->names, (std::map<int, std::string>{{11, "water"}, {41, "forest"}, {42, "forest"}}));
    EXPECT_EQ(shot.motion_bound_px, 0.05);
    EXPECT_EQ(shot.mesh_pixel_error, 0.25);
    EXPECT_EQ(shot.memory_gb, 1.5);
}

TEST(ReadShotDocument, HasDefaultsForAllButTerrainAndFlight) {
    const ShotDocument shot = read_shot_document(good_folder / "smallest_shot.yaml");
    EXPECT_EQ(shot.frames.first, 1);
    EXPECT_EQ(shot.frames.count, std::nullopt);
    EXPECT_EQ(shot.frames.date, std::nullopt);
    EXPECT_EQ(shot.frames.rate, (FrameRate{24, 1}));
    EXPECT_EQ(shot.image.width, 960);
    EXPECT_EQ(shot.image.height, 540);
    EXPECT_EQ(shot.shutter, Shutter{});
    EXPECT_TRUE(shot.frames.speeds.empty());
    EXPECT_EQ(shot.image.filter, FilterKind::Box);
    EXPECT_EQ(shot.sampling.tracer, TracerKind::Kinetic);
    EXPECT_EQ(shot.sampling.mirror_depth, 1);
    EXPECT_EQ(shot.look.sun_shadows, SunShadows::Baked);
    EXPECT_TRUE(shot.bodies.empty());
    EXPECT_TRUE(shot.layers.empty());
    EXPECT_FALSE(shot.classes);
    EXPECT_FALSE(shot.output.layer_files);
    EXPECT_EQ(shot.look.look, Look{});
    EXPECT_TRUE(shot.look.colours.empty());
    EXPECT_EQ(shot.output.folder, "out/smallest_shot");
    EXPECT_EQ(shot.output.name, "smallest_shot");
    EXPECT_EQ(shot.output.storage, FrameStorage{});
    EXPECT_EQ(shot.output.preview.burn_in, BurnIn{});
    EXPECT_EQ(shot.output.preview.view, ViewChoice{});
    EXPECT_EQ(shot.motion_bound_px, 0.01);
    EXPECT_EQ(shot.mesh_pixel_error, 0.5);
    EXPECT_EQ(shot.memory_gb, 4.0);
}

OutputDocument output_with(const std::string& assignment) {
    return read_shot_document(good_folder / "smallest_shot.yaml", std::vector<std::string>{assignment}).output;
}

TEST(ReadShotDocument, TakesOneCompressionForAllLayersThatBearIt) {
    EXPECT_EQ(output_with("output.compression=zips").storage,
              (FrameStorage{.beauty = Compression::Zips, .data = Compression::Zips}));
    EXPECT_EQ(output_with("output.compression=dwaa").storage,
              (FrameStorage{.beauty = Compression::Dwaa, .data = Compression::Zip}));
    EXPECT_EQ(output_with("output.compression.beauty=piz").storage,
              (FrameStorage{.beauty = Compression::Piz, .data = Compression::Zip}));
}

TEST(ReadShotDocument, TakesTrueForAllThatCanBeBurntIn) {
    EXPECT_EQ(output_with("output.burn_in=true").preview.burn_in, (BurnIn{.frame = true, .place = true, .time = true}));
    EXPECT_EQ(output_with("output.burn_in=[place]").preview.burn_in, (BurnIn{.place = true}));
    EXPECT_EQ(output_with("output.burn_in=false").preview.burn_in, BurnIn{});
}

TEST(ReadShotDocument, TakesOneLayerOrAListOfThemThatMayBeEmpty) {
    const auto layers = [](const std::string& assignment) {
        return read_shot_document(good_folder / "shot.yaml", std::vector<std::string>{assignment}).layers;
    };
    EXPECT_EQ(layers("layers=all"), layers_named("all"));
    EXPECT_EQ(layers("layers=N"), LayerSet{Layer::Normal});
    EXPECT_EQ(layers("layers=[light, albedo]"), (LayerSet{Layer::Direct, Layer::Shadow, Layer::Sky, Layer::Haze,
                                                          Layer::Background, Layer::Reflection, Layer::Albedo}));
    EXPECT_EQ(layers("layers=[]"), LayerSet{});
}

TEST(ReadShotDocument, TakesAnEmptySectionForOneOfDefaults) {
    const ShotDocument shot =
        read_shot_document(good_folder / "smallest_shot.yaml", std::vector<std::string>{"image=", "look.sun={}"});
    EXPECT_EQ(shot.image.width, 960);
    EXPECT_EQ(shot.look.look, Look{});
}

TEST(ReadShotDocument, TakesSecondsAndASpeed) {
    const std::vector<std::string> overrides = {"shutter.seconds=0.01", "frames.speed=0.5", "image.filter=tent"};
    const ShotDocument shot = read_shot_document(good_folder / "smallest_shot.yaml", overrides);
    EXPECT_EQ(shot.shutter.seconds, 0.01);
    EXPECT_EQ(shot.frames.speeds, (std::vector<FlightSpeed>{{0.0, 0.5}}));
    EXPECT_EQ(shot.image.filter, FilterKind::Tent);
    EXPECT_EQ(shot.image.filter_width_px, std::nullopt);
}

TEST(ReadShotDocument, KnowsBothSpellingsOfTheMiddle) {
    for (const std::string word : {"centre", "center"}) {
        const std::vector<std::string> overrides = {"shutter.phase=" + word};
        EXPECT_EQ(read_shot_document(good_folder / "shot.yaml", overrides).shutter.phase, Shutter::Phase::Centre);
    }
}

TEST(ReadBatchDocument, ListsShotsFromItsOwnFolder) {
    const BatchDocument batch = read_batch_document(good_folder / "batch.yaml");
    EXPECT_EQ(batch.shots, (std::vector{good_folder / "shot.yaml", good_folder / "smallest_shot.yaml"}));
}

}  // namespace
}  // namespace overfly
