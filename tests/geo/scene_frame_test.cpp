#include "geo/scene_frame.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace overfly {
namespace {

Geodetic place(double lon_deg, double lat_deg, double height_m) {
    return {Angle::degrees(lon_deg), Angle::degrees(lat_deg), height_m};
}

template <class Frame>
void expect_near(Point<Frame> p, Point<Frame> q, double tolerance_m) {
    EXPECT_NEAR(p.x, q.x, tolerance_m);
    EXPECT_NEAR(p.y, q.y, tolerance_m);
    EXPECT_NEAR(p.z, q.z, tolerance_m);
}

// The worked examples of IOGP Guidance Note 7-2 (methods 9602 and 9837), given there to the millimetre.
const Geodetic kNorthSea = place(2.0 + 7.0 / 60.0 + 46.380 / 3600.0, 53.0 + 48.0 / 60.0 + 33.820 / 3600.0, 73.0);

TEST(Ecef, AgreesWithTheGuidanceNote) {
    expect_near(ecef(kNorthSea), Point<Ecef>{3771793.968, 140253.342, 5124304.349}, 1e-3);
}

TEST(Ecef, HasTheAxesOfTheEllipsoid) {
    expect_near(ecef(place(0, 0, 0)), Point<Ecef>{6378137.0, 0, 0}, 1e-9);
    expect_near(ecef(place(90, 0, 0)), Point<Ecef>{0, 6378137.0, 0}, 1e-9);
    expect_near(ecef(place(12, 90, 10)), Point<Ecef>{0, 0, 6356752.314245 + 10}, 1e-6);
}

TEST(SceneFrame, AgreesWithTheGuidanceNote) {
    const SceneFrame frame(place(5, 55, 200));
    expect_near(frame.scene(kNorthSea), Point<Scene>{-189013.869, -128642.040, -4220.171}, 1e-3);
}

TEST(SceneFrame, OriginIsZeroAndAxesAreEastNorthUp) {
    const Geodetic origin = place(-105.43, 37.74, 1234.5);
    const SceneFrame frame(origin);
    expect_near(frame.scene(origin), Point<Scene>{0, 0, 0}, 1e-8);
    const Rotation<Scene, Scene> axes = frame.local_axes(origin);
    EXPECT_NEAR(axes.x.x, 1.0, 1e-15);
    EXPECT_NEAR(axes.y.y, 1.0, 1e-15);
    EXPECT_NEAR(axes.z.z, 1.0, 1e-15);
    EXPECT_GT(frame.scene(place(-105.42, 37.74, 1234.5)).x, 870.0);
    EXPECT_GT(frame.scene(place(-105.43, 37.75, 1234.5)).y, 1100.0);
    EXPECT_NEAR(frame.scene(place(-105.43, 37.74, 1235.5)).z, 1.0, 1e-8);
}

TEST(SceneFrame, KeepsTheCurvatureThatFramesPromise) {
    const SceneFrame frame(place(10, 45, 0));
    const double east_deg =
        100'000.0 / (6378137.0 * std::cos(45.0 * std::numbers::pi / 180.0)) * 180.0 / std::numbers::pi;
    EXPECT_NEAR(frame.scene(place(10 + east_deg, 45, 0)).z, -785.0, 5.0);
}

TEST(SceneFrame, LocalUpIsTheWayHeightGrows) {
    const SceneFrame frame(place(179.9, -80, 0));
    const Geodetic there = place(-179.5, -80.6, 500);
    const Vector<Scene> step = frame.scene(place(-179.5, -80.6, 501)) - frame.scene(there);
    EXPECT_NEAR(length(step - frame.local_axes(there).z), 0.0, 1e-8);
}

TEST(SceneFrame, GoesThereAndBackWithin10nm) {
    constexpr unsigned kSeed = 1;
    std::mt19937_64 random(kSeed);
    std::uniform_real_distribution<double> lon_deg(-180, 180), lat_deg(-90, 90), height_m(-11'000, 100'000);
    for (int i = 0; i < 1000; ++i) {
        const SceneFrame frame(place(lon_deg(random), lat_deg(random), 0));
        const Geodetic there = place(lon_deg(random), lat_deg(random), height_m(random));
        const Point<Scene> p = frame.scene(there);
        EXPECT_LT(distance(p, frame.scene(frame.geodetic(p))), 1e-8) << "seed " << kSeed << ", case " << i;
        EXPECT_NEAR(frame.geodetic(p).height_m, there.height_m, 1e-8) << "seed " << kSeed << ", case " << i;
    }
}

// GeographicLib's own example for Geod: JFK to LHR.
TEST(GeodesicLength, AgreesWithKarney) {
    EXPECT_NEAR(geodesic_length_m(place(-73.8, 40.6, 0), place(-0.5, 51.6, 4000)), 5551759.400, 1e-3);
    EXPECT_NEAR(geodesic_length_m(place(179.5, 0, 0), place(-179.5, 0, 0)), 6378137.0 * std::numbers::pi / 180.0, 1e-6);
}

}  // namespace
}  // namespace overfly
