#include "shot/flight_scene.h"

#include <gtest/gtest.h>

#include "config/read.h"
#include "io/temporary_folder.h"
#include "shot/frame_plan.h"
#include "shot/mesh_rescan.h"
#include "shot/shot_motion.h"

namespace overfly {
namespace {

// The demo's flight, and a stage that knows nothing of it yet.
struct Demo {
    TemporaryFolder folder;
    ShotDocument shot = read_shot_document(OVERFLY_SOURCE_DIR "/configs/demo.yaml", {});
    Stage stage{prepare_terrain(shot.terrain, folder / "cache"), middle_of(shot.flight)};

    FlightMeshReport fit() { return fit_mesh_to_flight(stage, shot, make_path(shot.flight, stage), folder / "cache"); }
    // As near as the shot's own frames come, by the motion that they are traced by.
    [[nodiscard]] double rescan_px() const {
        const CameraPath path = make_path(shot.flight, stage);
        const Motion motion = shot_motion(shot, path, plan_frames(shot, path.times()), stage);
        return largest_mesh_error_px(stage.full_mesh(), stage.frame(), stage.rays(),
                                     ClosestApproach(motion, {shot.image.width, shot.image.height}));
    }
};

TEST(FlightScene, IsWithinThePixelErrorOfEverySample) {
    Demo demo;
    std::size_t last = demo.stage.full_mesh().triangles.size();
    EXPECT_LT(demo.rescan_px(), 0.01) << "the full mesh is itself, up to float";
    for (const double pixel_error : {0.1, 0.5, 2.0}) {
        demo.shot.mesh_pixel_error = pixel_error;
        const FlightMeshReport report = demo.fit();
        EXPECT_FALSE(report.from_cache);
        EXPECT_EQ(report.triangles, demo.stage.mesh().triangles.size());
        EXPECT_LT(report.triangles, last);
        EXPECT_LE(report.largest_error_px, pixel_error);
        EXPECT_GT(report.largest_error_px, 0.5 * pixel_error) << "no finer than asked";
        EXPECT_LE(demo.rescan_px(), pixel_error);
        last = report.triangles;
        std::cout << pixel_error << " pixels: " << report.triangles << " of " << report.triangles_before
                  << " triangles, found " << report.largest_error_px << "\n";
    }
    EXPECT_LT(last, demo.stage.full_mesh().triangles.size() / 8);
}

TEST(FlightScene, ComesFromTheCacheForTheSameFlightOnly) {
    Demo demo;
    const FlightMeshReport first = demo.fit();
    const TerrainMesh mesh = demo.stage.mesh();
    const FlightMeshReport second = demo.fit();
    EXPECT_TRUE(second.from_cache);
    EXPECT_EQ(second.largest_error_px, first.largest_error_px);
    EXPECT_TRUE(demo.stage.mesh() == mesh);
    demo.shot.image.width = 1000;
    EXPECT_FALSE(demo.fit().from_cache);
    demo.shot.flight.keyframes.front().place.height_m += 1.0;
    EXPECT_FALSE(demo.fit().from_cache);
}

// What is seen doesn't change from one shot of a flight to another.
TEST(FlightScene, IsTheSameForOtherFramesOfTheFlight) {
    Demo demo;
    const CameraPath path = make_path(demo.shot.flight, demo.stage);
    const std::string text = approach_of(demo.shot, path, demo.stage).text();
    const auto with = [&](const auto& change) {
        ShotDocument shot = demo.shot;
        change(shot);
        return approach_of(shot, path, demo.stage).text();
    };
    EXPECT_EQ(with([](ShotDocument& s) { s.frames.rate = {120, 1}; }), text);
    EXPECT_EQ(with([](ShotDocument& s) { s.frames.rate = {24'000, 1'001}; }), text);
    EXPECT_EQ(with([](ShotDocument& s) { s.frames.start_s = 1.0, s.frames.count = 3; }), text);
    EXPECT_EQ(with([](ShotDocument& s) { s.shutter.angle = Angle::degrees(360.0); }), text);
    EXPECT_EQ(with([](ShotDocument& s) { s.motion_bound_px = 0.1; }), text);
    EXPECT_NE(with([](ShotDocument& s) { s.frames.start_s = -1.0; }), text) << "what is exposed must count";
}

TEST(FlightScene, WithoutAnErrorLooksAtEverySample) {
    Demo demo;
    demo.shot.mesh_pixel_error = 0.0;
    const FlightMeshReport report = demo.fit();
    EXPECT_EQ(report.triangles, report.triangles_before);
    EXPECT_EQ(&demo.stage.mesh(), &demo.stage.full_mesh());
}

}  // namespace
}  // namespace overfly
