#include "flight/body_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flight/flights.h"
#include "geo/scene_frame.h"

namespace overfly {
namespace {

using namespace flights;

Outline outline(std::initializer_list<std::pair<double, double>> lon_lat_deg) {
    Outline result;
    for (const auto& [lon, lat] : lon_lat_deg) result.push_back({deg(lon), deg(lat)});
    return result;
}

TEST(MiddleOf, IsInTheMiddle) {
    const LonLat middle = middle_of(outline({{7.0, 46.0}, {7.2, 46.0}, {7.2, 46.2}, {7.0, 46.2}}));
    EXPECT_NEAR(middle.lon.degrees(), 7.1, 1e-3);
    EXPECT_NEAR(middle.lat.degrees(), 46.1, 1e-3);
}

TEST(MiddleOf, HoldsAcrossTheAntimeridianAndAPole) {
    EXPECT_NEAR(std::abs(middle_of(outline({{179.9, 10}, {-179.9, 10}, {180, 10.1}})).lon.degrees()), 180.0, 1e-9);
    EXPECT_NEAR(middle_of(outline({{0, 89.9}, {120, 89.9}, {240, 89.9}})).lat.degrees(), 90.0, 1e-9);
    // However the turns are counted.
    EXPECT_NEAR(middle_of(outline({{359.9, 0}, {0.1, 0}})).lon.degrees(), 0.0, 1e-12);
}

TEST(LevelPolygon, IsLevelAndAboveItsCorners) {
    const Outline lake = outline({{7.0, 46.0}, {7.1, 46.0}, {7.05, 46.1}});
    const LonLat at = middle_of(lake);
    const Geodetic middle{at.lon, at.lat, 430.0};
    const Polygon polygon = level_polygon(lake, middle);
    ASSERT_EQ(polygon.size(), 3U);
    const SceneFrame frame(middle);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(polygon[i].z, 0.0);
        const Geodetic place = frame.geodetic(polygon[i]);
        const double away_m = std::hypot(polygon[i].x, polygon[i].y);
        // Above the level surface by what the header says. Where it is above, the corner itself is: seen from the
        // middle's vertical, a little farther out than straight below.
        EXPECT_NEAR(place.height_m - 430.0, away_m * away_m / 12'742'000.0, 0.01);
        EXPECT_LT(geodesic_length_m(place, {lake[i].lon, lake[i].lat, 0.0}), 0.02);
    }
}

TEST(LevelPolygon, GrowsWithTheHeightOfTheLake) {
    const Outline lake = outline({{0.0, 0.0}, {0.01, 0.0}, {0.01, 0.01}, {0.0, 0.01}});
    const LonLat at = middle_of(lake);
    const auto width_m = [&](double height_m) {
        const Polygon p = level_polygon(lake, {at.lon, at.lat, height_m});
        return p[1].x - p[0].x;
    };
    EXPECT_NEAR(width_m(4000.0) / width_m(0.0), 1.0 + 4000.0 / 6'378'137.0, 1e-9);
}

}  // namespace
}  // namespace overfly
