#include <gtest/gtest.h>

#include <iostream>

#include "shot/flight_scene.h"
#include "two_ways/blurred_frame.h"

namespace overfly {
namespace {

using namespace testing;

class BlurError : public ::testing::Test {
  protected:
    static PreparedTerrain terrain() { return prepared(OVERFLY_SOURCE_DIR "/terrain/blanca_peak_utm13n_75m.tif"); }
};

// A small picture of the dive, half a frame at 24 per second: sixteen lines against 1,024 samples.
TEST_F(BlurError, SixteenLinesAreWithinFourThousandths) {
    PreparedTerrain blanca = terrain();
    const FlightDocument document = flight_over(blanca.scene.report, diving_flight());
    const Stage stage(std::move(blanca), middle_of(document));
    const Sight sight = sight_of(motion_over(document, stage, {0.01, 240, 135, 1.0 / 6.0}));
    const FrameMaker maker = {stage, sight, {240, 135}, {1.0, 1.0 + 1.0 / 48.0}};
    const Frame reference = maker.by_samples(1024);
    const double error = root_mean_square(maker.by_lines(16), reference);
    std::cout << "RMSE of 16 lines against 1,024 samples: " << error << "\n";
    EXPECT_LT(error, 0.004);
    // Beside it, so that the bound means something: as many samples as lines are worse.
    EXPECT_LT(error, root_mean_square(maker.by_samples(16), reference));
}

// On a mesh made for the flight a line sweeps many cells of the raster, and their light, within one triangle.
TEST_F(BlurError, SixteenLinesAreAsGoodOnFewTriangles) {
    PreparedTerrain blanca = terrain();
    const FlightDocument document = flight_over(blanca.scene.report, diving_flight());
    Stage stage(std::move(blanca), middle_of(document));
    ShotDocument shot;
    shot.image.width = 240;
    shot.image.height = 135;
    shot.mesh_pixel_error = 1.0;
    const FlightMeshReport mesh =
        fit_mesh_to_flight(stage, shot, make_path(document, stage),
                           std::filesystem::path(::testing::TempDir()) / "overfly-no-cache" / "flight");
    EXPECT_LT(mesh.triangles, mesh.triangles_before / 10);
    const Sight sight = sight_of(motion_over(document, stage, {0.01, 240, 135, 1.0 / 6.0}));
    const FrameMaker maker = {stage, sight, {240, 135}, {1.0, 1.0 + 1.0 / 48.0}};
    const double error = root_mean_square(maker.by_lines(16), maker.by_samples(1024));
    std::cout << "RMSE of 16 lines against 1,024 samples: " << error << "\n";
    EXPECT_LT(error, 0.004);
}

// Following the visible point gives the picture that asking each line anew gives.
TEST_F(BlurError, KineticLinesAreTheIntervalTracers) {
    PreparedTerrain blanca = terrain();
    const FlightDocument document = flight_over(blanca.scene.report, diving_flight());
    const Stage stage(std::move(blanca), middle_of(document));
    const Sight sight = sight_of(motion_over(document, stage, {0.01, 160, 90, 1.0 / 6.0}));
    const FrameMaker maker = {stage, sight, {160, 90}, {1.0, 1.0 + 1.0 / 48.0}};
    EXPECT_LT(root_mean_square(maker.by_kinetic_lines(8), maker.by_lines(8)), 1e-3);
}

// An instant: no blur, so lines and samples at the same places see the same.
TEST_F(BlurError, AnInstantIsTheSameForBothTracers) {
    PreparedTerrain blanca = terrain();
    const FlightDocument document = flight_over(blanca.scene.report, level_flight());
    const Stage stage(std::move(blanca), middle_of(document));
    const Sight sight = sight_of(motion_over(document, stage, {0.01, 160, 90, 1.0 / 6.0}));
    const FrameMaker maker = {stage, sight, {160, 90}, {0.7, 0.7}};
    const Frame lines = maker.by_lines(4);
    const Frame samples = maker.by_samples(4);
    EXPECT_LT(root_mean_square(lines, samples), 1e-5);
}

}  // namespace
}  // namespace overfly
