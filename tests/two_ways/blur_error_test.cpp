#include <gtest/gtest.h>

#include "shot/flight_scene.h"
#include "two_ways/frame_laws.h"

namespace overfly {
namespace {

using namespace testing;

constexpr PictureSize kSize = {240, 135};
constexpr PictureSize kMiddle = {128, 72};  // of a picture of kSize
constexpr double kShareOfWidth = kMiddle.width / 240.0;
constexpr PictureSize kSmall = {96, 54};

// The middle of a small picture of the dive.
TEST(BlurError, SixteenLinesAreWithinFourThousandths) {
    const SampleFlight dive(diving_flight());
    const Sight sight = dive.sight_of_middle(kMiddle, kShareOfWidth);
    expect_sixteen_lines_suffice({dive.stage, sight, kMiddle, half_a_frame(1.0)}, "full mesh");
}

// On a mesh made for the flight a line sweeps many cells of the raster, and their light, within one triangle.
TEST(BlurError, SixteenLinesAreAsGoodOnFewTriangles) {
    SampleFlight dive(diving_flight());
    ShotDocument shot;
    shot.image.width = kSize.width;
    shot.image.height = kSize.height;
    shot.mesh_pixel_error = 1.0;
    const FlightMeshReport mesh =
        fit_mesh_to_flight(dive.stage, shot, make_path(dive.document, dive.stage),
                           std::filesystem::path(::testing::TempDir()) / "overfly-no-cache" / "flight");
    EXPECT_LT(mesh.triangles, mesh.triangles_before / 10);
    const Sight sight = dive.sight_of_middle(kMiddle, kShareOfWidth);
    expect_sixteen_lines_suffice({dive.stage, sight, kMiddle, half_a_frame(1.0)}, "few triangles");
}

TEST(BlurError, KineticLinesAreTheIntervalTracers) {
    const SampleFlight dive(diving_flight());
    const Sight sight = dive.sight(kSmall);
    expect_kinetic_lines_to_be_the_interval_tracers({dive.stage, sight, kSmall, half_a_frame(1.0)}, 8);
}

// An instant: no blur, so lines and samples at the same places see the same.
TEST(BlurError, AnInstantIsTheSameForBothTracers) {
    const SampleFlight level(level_flight());
    const Sight sight = level.sight(kSmall);
    const FrameMaker maker = {level.stage, sight, kSmall, {0.7, 0.7}};
    const Frame lines = maker.by_lines(4);
    const Frame samples = maker.by_samples(4);
    EXPECT_LT(root_mean_square(lines, samples), 1e-5);
}

}  // namespace
}  // namespace overfly
