#include "flight/path_report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flights.h"

namespace overfly {
namespace {

using flights::deg;
using flights::keyframe;
using flights::path;
using flights::place;

TEST(PathReport, OfALevelCruise) {
    const CameraPath flight =
        path({keyframe(0, place(10.0, 50.0, 1000.0), {}), keyframe(100, place(10.1, 50.0, 1000.0), {})});
    const PathReport report = report_path(flight, flights::bare_ellipsoid(), 24.0);
    const double ground_m = geodesic_length_m(flight.place_at(0), flight.place_at(100));
    // 1 km up, the way is longer by 1 km over the Earth's radius of 6,390 km eastward at 50 N.
    EXPECT_NEAR(report.length_m, ground_m * (1.0 + 1000.0 / 6.39e6), 0.05);
    EXPECT_EQ(report.duration_s, 100.0);
    EXPECT_NEAR(report.mean_m_per_s, report.length_m / 100.0, 1e-9);
    EXPECT_NEAR(report.slowest_m_per_s.value, report.mean_m_per_s, 1e-3);
    EXPECT_NEAR(report.fastest_m_per_s.value, report.mean_m_per_s, 1e-3);
    EXPECT_LT(report.climb_m, 1e-6);
    EXPECT_LT(report.hardest_g.value, 1e-3);
    ASSERT_TRUE(report.lowest);
    EXPECT_NEAR(report.lowest->clearance_m, 1000.0, 1e-6);
    EXPECT_FALSE(report.goes_below_ground());
    EXPECT_EQ(report.off_terrain_share, 0.0);
}

TEST(PathReport, RatesOfTurning) {
    const FlightPlace here = place(0.0, 0.0, 100.0);
    const CameraPath pan = path(
        {keyframe(0, here, {deg(350.0), deg(0.0), deg(0.0)}), keyframe(10, here, {deg(30.0), deg(0.0), deg(0.0)})});
    const PathReport report = report_path(pan, flights::bare_ellipsoid(), 24.0);
    EXPECT_NEAR(report.fastest_turn_deg_per_s.value, 4.0, 1e-9);
    EXPECT_NEAR(report.fastest_heading_deg_per_s.value, 4.0, 1e-9);
    EXPECT_NEAR(report.fastest_pitch_deg_per_s.value, 0.0, 1e-9);
    EXPECT_EQ(report.length_m, 0.0);

    const CameraPath roll = path({keyframe(0, here, {}), keyframe(10, here, {deg(0.0), deg(-10.0), deg(360.0)})});
    EXPECT_NEAR(report_path(roll, flights::bare_ellipsoid(), 24.0).fastest_roll_deg_per_s.value, 36.0, 1e-9);
}

TEST(PathReport, FindsTheSummitBetweenTwoSamples) {
    // A ridge 300 m high and 200 m wide at lon 0.00537, crossed at 111 m/s, sampled once a second.
    Surroundings world = flights::bare_ellipsoid();
    world.ground_height_m = [](Angle lon, Angle) {
        const double off_m = (lon.degrees() - 0.00537) / flights::kDegPerM;
        return 300.0 * std::exp(-off_m * off_m / (100.0 * 100.0));
    };
    const CameraPath flight =
        path({keyframe(0, place(0.0, 0.0, 290.0), {}), keyframe(10, place(0.01, 0.0, 290.0), {})});
    const PathReport report = report_path(flight, world, 1.0);
    ASSERT_TRUE(report.lowest);
    EXPECT_NEAR(report.lowest->clearance_m, -10.0, 1e-6);
    EXPECT_NEAR(report.lowest->time_s, 5.37, 1e-3);
    EXPECT_NEAR(report.lowest->lon.degrees(), 0.00537, 1e-6);
    EXPECT_TRUE(report.goes_below_ground());
}

TEST(PathReport, CountsTheTimeOffTheTerrainAndTheClimb) {
    Surroundings world = flights::bare_ellipsoid();
    world.ground_height_m = [](Angle lon, Angle) -> std::optional<double> {
        if (lon.degrees() > 0.0075) return std::nullopt;
        return 0.0;
    };
    const CameraPath flight = path({keyframe(0, place(0.0, 0.0, 100.0), {}), keyframe(5, place(0.005, 0.0, 150.0), {}),
                                    keyframe(10, place(0.01, 0.0, 120.0), {})});
    const PathReport report = report_path(flight, world, 50.0);
    EXPECT_NEAR(report.off_terrain_share, 0.25, 0.01);
    EXPECT_NEAR(report.climb_m, 50.0, 1e-6);
    EXPECT_NEAR(report.lowest->clearance_m, 100.0, 1e-9);

    world.ground_height_m = [](Angle, Angle) { return std::optional<double>(); };
    EXPECT_FALSE(report_path(flight, world, 10.0).lowest);
    EXPECT_FALSE(report_path(flight, world, 10.0).goes_below_ground());
}

TEST(PathReport, CircleHasItsAcceleration) {
    // 100 m/s round a circle of 1000 m: 10 m/s^2.
    std::vector<Keyframe> keys;
    for (int i = 0; i <= 36; ++i) {
        const double angle = i * std::numbers::pi / 18.0, r_deg = 1000.0 * flights::kDegPerM;
        keys.push_back(
            keyframe(angle * 10.0, place(r_deg * std::cos(angle), r_deg * std::sin(angle) * 1.0067395, 500.0), {}));
    }
    const PathReport report = report_path(path(keys), flights::bare_ellipsoid(), 24.0);
    EXPECT_NEAR(report.hardest_g.value, 10.0 / 9.80665, 0.03);  // most at the ends, where the path knows one side only
    EXPECT_NEAR(report.length_m, 2.0 * std::numbers::pi * 1000.0, 2.0);
}

TEST(PathReport, OfOneKeyframe) {
    const PathReport report = report_path(path({keyframe(3, place(0, 0, 70.0), {})}), flights::bare_ellipsoid(), 24.0);
    EXPECT_EQ(report.length_m, 0.0);
    EXPECT_EQ(report.slowest_m_per_s.value, 0.0);
    EXPECT_NEAR(report.lowest->clearance_m, 70.0, 1e-9);
}

}  // namespace
}  // namespace overfly
