#include <gtest/gtest.h>

#include <tuple>

#include "shot/flight_scene.h"
#include "trace/agreement.h"
#include "two_ways/blurred_frame.h"

namespace overfly {
namespace {

using namespace testing;

struct Case {
    const char* dem;
    bool dives;
};

// How GoogleTest names a case.
void PrintTo(const Case& c, std::ostream* out) { *out << c.dem << (c.dives ? ", a dive" : ", level"); }

class SharedTerrain : public ::testing::TestWithParam<Case> {};

// 30 m projected; 1 m lidar with sheer walls; geographic with voids.
INSTANTIATE_TEST_SUITE_P(Flights, SharedTerrain,
                         ::testing::Values(Case{"bigtujunga_srtm30m_utm11n.tif", false},
                                           Case{"bigtujunga_srtm30m_utm11n.tif", true},
                                           Case{"nrw_lidar_dsm1m_utm32n.tif", false},
                                           Case{"nrw_lidar_dsm1m_utm32n.tif", true},
                                           Case{"rainier_adams_srtm90m_cog_lerc.tif", false},
                                           Case{"rainier_adams_srtm90m_cog_lerc.tif", true}));

TEST_P(SharedTerrain, TracersAgree) {
    PreparedTerrain terrain = prepared(std::filesystem::path(OVERFLY_SHARED_DATA) / "dem" / GetParam().dem);
    const FlightDocument document =
        flight_over(terrain.scene.report, GetParam().dives ? diving_flight() : level_flight());
    const Stage stage(std::move(terrain), middle_of(document));
    const Agreement agreement = compare(DiscreteTracer(stage.rays()), IntervalTracer(stage.mesh()), stage.mesh(),
                                        motion_over(document, stage), AgreementOptions{});
    std::cout << GetParam().dem << (GetParam().dives ? " dive" : " level") << ": " << agreement.pairs
              << " pairs, same triangle " << agreement.same_share() << ", else same depth " << agreement.same_depth
              << ", at an edge " << agreement.near_edge << ", neither " << agreement.unexplained << "\n";
    EXPECT_EQ(agreement.pairs, 200'000);
    EXPECT_GE(agreement.same_share(), 0.9999);
    EXPECT_EQ(agreement.unexplained, 0);
}

// Half a pixel of a picture 960 wide, on every sample of terrain that is seen from near by.
TEST(SharedTerrainMesh, IsWithinHalfAPixelOfEverySample) {
    for (const auto& flight : {level_flight(), diving_flight()}) {
        PreparedTerrain terrain =
            prepared(std::filesystem::path(OVERFLY_SHARED_DATA) / "dem" / "bigtujunga_srtm30m_utm11n.tif");
        const FlightDocument document = flight_over(terrain.scene.report, flight);
        Stage stage(std::move(terrain), middle_of(document));
        const FlightMeshReport mesh =
            fit_mesh_to_flight(stage, {}, make_path(document, stage),
                               std::filesystem::path(::testing::TempDir()) / "overfly-no-cache" / "flight");
        std::cout << mesh.triangles << " of " << mesh.triangles_before << " triangles, at most "
                  << mesh.largest_error_px << " pixels off, " << mesh.seconds << " s\n";
        EXPECT_LE(mesh.largest_error_px, 0.5);
        EXPECT_LT(mesh.triangles, mesh.triangles_before / 2);
    }
}

// The figure of the first flight: 960x540, sixteen lines, against 1,024 samples.
TEST(SharedTerrainBlur, SixteenLinesAtFullSize) {
    PreparedTerrain terrain =
        prepared(std::filesystem::path(OVERFLY_SHARED_DATA) / "dem" / "bigtujunga_srtm30m_utm11n.tif");
    const FlightDocument document = flight_over(terrain.scene.report, level_flight());
    const Stage stage(std::move(terrain), middle_of(document));
    const Sight sight = sight_of(motion_over(document, stage, {0.01, 960, 540, 1.0 / 6.0}));
    const FrameMaker maker = {stage, sight, {960, 540}, {1.0, 1.0 + 1.0 / 48.0}};
    const Frame reference = maker.by_samples(1024);
    const double error = root_mean_square(maker.by_lines(16), reference);
    std::cout << "RMSE of 16 lines against 1,024 samples: " << error << "\n";
    EXPECT_LT(error, 0.004);
}

}  // namespace
}  // namespace overfly
