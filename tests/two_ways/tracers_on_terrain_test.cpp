#include <gtest/gtest.h>

#include "trace/agreement.h"
#include "two_ways/terrain_flights.h"

namespace overfly {
namespace {

using namespace testing;

// In 99.99 % of random (sample, time) pairs both name the same triangle; the rest are ties that no one could decide.
void expect_agreement(const ShareFlight& flight) {
    PreparedTerrain terrain = prepared(OVERFLY_SOURCE_DIR "/terrain/blanca_peak_utm13n_75m.tif");
    const FlightDocument document = flight_over(terrain.scene.report, flight);
    const Stage stage(std::move(terrain), middle_of(document));
    AgreementOptions options;
    options.pairs = 30'000;
    const Agreement agreement = compare(DiscreteTracer(stage.rays()), IntervalTracer(stage.mesh()), stage.mesh(),
                                        motion_over(document, stage), options);
    EXPECT_EQ(agreement.pairs, options.pairs);
    EXPECT_GE(agreement.same_share(), 0.9999) << "seed " << options.seed;
    EXPECT_EQ(agreement.unexplained, 0) << "seed " << options.seed;
}

TEST(TracersOnTerrain, AgreeOnALevelFlight) { expect_agreement(level_flight()); }

TEST(TracersOnTerrain, AgreeOnADive) { expect_agreement(diving_flight()); }

}  // namespace
}  // namespace overfly
