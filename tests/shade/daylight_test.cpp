#include "shade/daylight.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "core/low_discrepancy.h"

namespace overfly {
namespace {

constexpr Vector<Scene> kUp = {0.0, 0.0, 1.0};
constexpr Rgb kBlack = {};
constexpr Rgb kWhite = {1.0F, 1.0F, 1.0F};

Look clear_look() { return {.sun_azimuth = Angle::degrees(115), .sun_elevation = Angle::degrees(22)}; }

void expect_near(Rgb a, Rgb b, float tolerance) {
    EXPECT_NEAR(a.r, b.r, tolerance);
    EXPECT_NEAR(a.g, b.g, tolerance);
    EXPECT_NEAR(a.b, b.b, tolerance);
}

TEST(Daylight, TheSunStandsWhereTheLookSays) {
    const Vector<Scene> east =
        Daylight({.sun_azimuth = Angle::degrees(90), .sun_elevation = Angle::degrees(0)}).to_sun();
    EXPECT_NEAR(east.x, 1.0, 1e-12);
    const Vector<Scene> v = Daylight(clear_look()).to_sun();
    EXPECT_NEAR(length(v), 1.0, 1e-12);
    EXPECT_NEAR(v.z, std::sin(22 * std::numbers::pi / 180), 1e-12);
    EXPECT_LT(v.y, 0.0);  // 115 degrees: south of east
}

TEST(Daylight, AtTheZenithTheSunIsWhiteAndTwo) {
    expect_near(Daylight({.sun_elevation = Angle::degrees(90)}).sun(), 2.0F * kWhite, 2e-3F);
}

TEST(Daylight, ALowerSunIsDimmerAndRedder) {
    Rgb higher = Daylight({.sun_elevation = Angle::degrees(90)}).sun();
    for (const double elevation_deg : {60.0, 30.0, 15.0, 5.0, 1.0}) {
        const Rgb sun = Daylight({.sun_elevation = Angle::degrees(elevation_deg)}).sun();
        EXPECT_LT(sun.r, higher.r) << elevation_deg;
        EXPECT_LT(sun.b / sun.r, higher.b / higher.r) << elevation_deg;
        higher = sun;
    }
    EXPECT_EQ(Daylight({.sun_elevation = Angle::degrees(-1)}).sun(), kBlack);
}

TEST(Daylight, StrengthsAndExposureAreFactors) {
    const Daylight one(clear_look());
    Look look = clear_look();
    look.exposure_stops = 1.0;
    look.sky_strength = 0.5;
    const Daylight other(look);
    expect_near(other.sun(), 2.0F * one.sun(), 1e-5F);
    expect_near(other.sky(), one.sky(), 1e-5F);
}

// Level ground is lit by what `background` shows, here by another rule than the class's own: midpoints in elevation
// and azimuth.
TEST(Daylight, SkyIsTheIrradianceOfTheBackground) {
    const Daylight day(clear_look());
    Rgb sum;
    constexpr int kSteps = 200;
    for (int i = 0; i < kSteps; ++i) {
        const double rise = std::sqrt((i + 0.5) / kSteps);  // equal steps of its square are cosine-weighted
        const double level = std::sqrt(1.0 - rise * rise);
        for (int j = 0; j < kSteps; ++j) {
            const double turn = 2.0 * std::numbers::pi * (j + 0.5) / kSteps;
            sum += day.background({level * std::cos(turn), level * std::sin(turn), rise}, kUp);
        }
    }
    expect_near(day.sky(), (1.0F / (kSteps * kSteps)) * sum, 2e-3F);
}

TEST(Daylight, TheSkyIsBlueAboveAndPalerAtTheHorizon) {
    const Daylight day(clear_look());
    const Vector<Scene> away = {-day.to_sun().x, -day.to_sun().y, 0.0};
    const Rgb zenith = day.background(kUp, kUp);
    const Rgb horizon = day.background(normalized(away), kUp);
    EXPECT_GT(zenith.b, 2.0F * zenith.r);
    EXPECT_LT(horizon.b, 2.0F * horizon.r);
    EXPECT_GT(horizon.g, zenith.g);
}

TEST(Haze, TendsToTheHorizonWithDistance) {
    const Daylight day(clear_look());
    const Vector<Scene> direction = {0.6, 0.8, 0.0};
    const Rgb horizon = day.background(direction, kUp);
    for (const Rgb behind : {kBlack, 3.0F * kWhite}) {
        expect_near(day.through_air(behind, {1e6, 0.0, 0.0}, direction), horizon, 1e-6F);
    }
    float brighter = 1.0F;
    for (const double distance_m : {0.0, 1e3, 1e4, 3e4, 1e5}) {
        const float contrast = day.through_air(kWhite, {distance_m, 900.0, 100.0}, direction).g -
                               day.through_air(kBlack, {distance_m, 900.0, 100.0}, direction).g;
        EXPECT_LE(contrast, brighter);
        brighter = contrast;
    }
}

TEST(Haze, IsNoneWithoutDistanceOrWithVisibilityZero) {
    const Rgb behind = {0.1F, 0.2F, 0.3F};
    EXPECT_EQ(Daylight(clear_look()).through_air(behind, {0.0, 900.0, 100.0}, {1.0, 0.0, 0.0}), behind);
    Look look = clear_look();
    look.visibility_m = 0.0;
    EXPECT_EQ(Daylight(look).through_air(behind, {1e6, 900.0, 100.0}, {1.0, 0.0, 0.0}), behind);
}

TEST(Haze, LeavesTwoPercentAtTheVisibility) {
    for (const double visibility_m : {5e3, 60e3, 200e3}) {
        Look look = clear_look();
        look.visibility_m = visibility_m;
        const Daylight day(look);
        const Daylight::AirPath path = {visibility_m, 0.0, 0.0};
        const Rgb white = day.through_air(kWhite, path, {1.0, 0.0, 0.0});
        const Rgb black = day.through_air(kBlack, path, {1.0, 0.0, 0.0});
        EXPECT_NEAR(white.g - black.g, 0.02F, 1e-4F);
        EXPECT_GT(white.r - black.r, 0.02F);
        EXPECT_LT(white.b - black.b, 0.02F);
    }
}

// The closed form against the sum of thin layers, on paths up, down and level.
TEST(Haze, IntegratesTheDensityAlongThePath) {
    const Daylight day(clear_look());
    const auto depth = [&](const Daylight::AirPath& path) {
        return -std::log(day.through_air(kWhite, path, {1.0, 0.0, 0.0}).g -
                         day.through_air(kBlack, path, {1.0, 0.0, 0.0}).g);
    };
    const std::array<Daylight::AirPath, 5> paths = {
        {{2e4, 0.0, 4e3}, {2e4, 4e3, 0.0}, {2e4, 3e3, 3e3}, {2e4, 3e3, 3024.0}, {2e4, 3e3, 3026.0}}};
    for (const Daylight::AirPath& path : paths) {
        constexpr int kLayers = 100;
        double sum = 0.0;
        for (int i = 0; i < kLayers; ++i) {
            const double height_m = path.from_height_m + (path.to_height_m - path.from_height_m) * (i + 0.5) / kLayers;
            sum += depth({path.distance_m / kLayers, height_m, height_m});
        }
        EXPECT_NEAR(depth(path) / sum, 1.0, 1e-3) << path.from_height_m << " to " << path.to_height_m;
    }
}

TEST(Ball, DistanceIsThatOfItsSurface) {
    const Point<Scene> above = {1000.0, -2000.0, 5000.0};
    const Vector<Scene> up = up_at(above);
    const auto down = distance_to_ball_m(above, -up, 300.0);
    ASSERT_TRUE(down.has_value());
    EXPECT_NEAR(*down, height_over_ball_m(above) - 300.0, 1e-6);
    for (const double sink : {0.05, 0.2, 0.7}) {
        const Vector<Scene> direction = {std::sqrt(1.0 - sink * sink), 0.0, -sink};
        const auto far = distance_to_ball_m(above, direction, 300.0);
        ASSERT_TRUE(far.has_value());
        EXPECT_NEAR(height_over_ball_m(above + *far * direction), 300.0, 1e-5);
    }
    EXPECT_FALSE(distance_to_ball_m(above, {1.0, 0.0, 0.0}, 300.0).has_value());  // the horizon dips by 2 degrees
    EXPECT_FALSE(distance_to_ball_m(above, up, 300.0).has_value());
}

// Many views at once are what each is by itself, to the bit.
TEST(Daylight, ManyViewsThroughAirAreTheSameAsEach) {
    const Daylight day(clear_look());
    AirViews views;
    std::array<Rgb, AirViews::kSize> expected{};
    for (std::size_t i = 0; i < AirViews::kSize; ++i) {
        const auto p = low_discrepancy_point(1, static_cast<std::uint32_t>(i));
        const auto q = low_discrepancy_point(2, static_cast<std::uint32_t>(i));
        const Rgb behind = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
        // Also level paths, for which there is a series, and such as go below the lowest ground.
        const double from_m = 4000.0 * q[0] - 100.0, to_m = i % 4 == 0 ? from_m + 20.0 * q[1] : 4000.0 * q[1];
        const Daylight::AirPath path = {1e5 * q[2], from_m, to_m};
        const Vector<Scene> direction = normalized(Vector<Scene>{p[0] - 0.5, p[1] - 0.5, q[2] - 0.5});
        expected[i] = day.through_air(behind, path, direction);
        views.set(i, behind,
                  {static_cast<float>(path.distance_m), static_cast<float>(from_m), static_cast<float>(to_m),
                   static_cast<float>(dot(direction, day.to_sun()))});
    }
    look_through(day.air(), views, AirViews::kSize);
    for (std::size_t i = 0; i < AirViews::kSize; ++i) EXPECT_EQ(views.seen(i), expected[i]) << i;
}

}  // namespace
}  // namespace overfly
