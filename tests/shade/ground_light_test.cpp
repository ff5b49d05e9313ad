#include "shade/ground_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "core/parallel.h"
#include "shade/sky_light.h"
#include "shade/sun_shadow.h"
#include "support/terrains.h"

namespace overfly {
namespace {

using testing::heightfield;

constexpr double kPost_m = 50.0;
const ColourRamp kWhite{{{0.0F, {1.0F, 1.0F, 1.0F}}}};

// Asks about one ray at a time.
template <class F>
AreBlocked each(F is_blocked) {
    return [is_blocked](std::span<const LightRay> rays) {
        std::uint32_t blocked = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (is_blocked(rays[i].from, rays[i].direction)) blocked |= 1U << i;
        }
        return blocked;
    };
}

const AreBlocked kOpen = [](std::span<const LightRay>) { return 0U; };

Look low_sun_in_the_east() { return {.sun_azimuth = Angle::degrees(90), .sun_elevation = Angle::degrees(30)}; }

// Ground of a height function, by steps along the ray.
AreBlocked blocked_by(double (*ground_m)(double x, double y)) {
    return each([ground_m](Point<Scene> from, Vector<Scene> d) {
        for (double t = 5.0; t < 4'000.0; t += 10.0) {
            const Point<Scene> p = from + t * d;
            if (p.z < ground_m(p.x, p.y)) return true;
        }
        return false;
    });
}

double wall_m(double x, double /*y*/) { return x > 500.0 && x < 600.0 ? 300.0 : 0.0; }
double valley_m(double x, double /*y*/) { return std::abs(x); }

float brightness(Rgb c) { return c.r + c.g + c.b; }

TEST(GroundLight, OfLevelGroundIsSunAndSkyInClosedForm) {
    // Small enough for the Earth to be flat: 100 m turn the vertical by 1.6e-5.
    const TerrainMesh mesh = heightfield(5, 5, kPost_m, [](double, double) { return 0.0; });
    const Daylight day(low_sun_in_the_east());
    const GroundLight light = light_ground(mesh, kWhite, day, kOpen);
    const Rgb expected = 0.5F * day.sun() + day.sky();  // sin 30 degrees; no ground around is seen
    for (const Rgb& seen : light.radiance) {
        EXPECT_NEAR(seen.r, expected.r, 1e-4F);
        EXPECT_NEAR(seen.g, expected.g, 1e-4F);
        EXPECT_NEAR(seen.b, expected.b, 1e-4F);
    }
}

TEST(GroundLight, OnASlopeFollowsTheSun) {
    const auto towards_sun = [](double x, double) { return -0.5 * x; };
    const auto away = [](double x, double) { return 0.5 * x; };
    const Daylight day(low_sun_in_the_east());
    const Rgb bright = light_ground(heightfield(5, 5, kPost_m, towards_sun), kWhite, day, kOpen).radiance[12];
    const Rgb dark = light_ground(heightfield(5, 5, kPost_m, away), kWhite, day, kOpen).radiance[12];
    const double facing = (0.5 * std::cos(std::asin(0.5)) + 0.5) / std::sqrt(1.25);
    EXPECT_GT(bright.g, static_cast<float>(facing) * day.sun().g);
    EXPECT_LT(bright.g, static_cast<float>(facing) * day.sun().g + 1.3F * day.sky().g);
    EXPECT_LT(dark.g, 0.4F * bright.g);
}

TEST(GroundLight, IsTheColourTimesTheLight) {
    const TerrainMesh mesh = heightfield(9, 9, kPost_m, testing::rough_ground);
    const Daylight day(low_sun_in_the_east());
    const ColourRamp of_a_file{
        {{-500.0F, {0.1F, 0.2F, 0.3F}}, {0.0F, {0.9F, 0.1F, 0.4F}}, {500.0F, {0.3F, 0.8F, 0.2F}}}};
    const GroundLight white = light_ground(mesh, kWhite, day, kOpen);
    const GroundLight coloured = light_ground(mesh, of_a_file, day, kOpen);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        EXPECT_EQ(coloured.radiance[v], of_a_file.at(mesh.elevation_m[v]) * white.radiance[v]);
    }
}

TEST(GroundLight, IsTheSameForAnyNumberOfThreads) {
    const TerrainMesh mesh = heightfield(90, 90, kPost_m, testing::rough_ground);
    const Daylight day(low_sun_in_the_east());
    const AreBlocked east_is_closed = each([](Point<Scene> p, Vector<Scene> d) { return d.x > 0.6 && p.x > p.y; });
    const int before = thread_limit();
    limit_threads(1);
    const GroundLight one = light_ground(mesh, kWhite, day, east_is_closed);
    limit_threads(std::max(before, 2));
    const GroundLight many = light_ground(mesh, kWhite, day, east_is_closed);
    limit_threads(before);
    EXPECT_EQ(one.radiance, many.radiance);
}

TEST(SunShare, AWallCastsItsShadowAsFarAsItShould) {
    const TerrainMesh mesh = heightfield(41, 3, kPost_m, wall_m);
    const Daylight day(low_sun_in_the_east());
    const auto share = sun_share(mesh, day.to_sun(), blocked_by(wall_m));
    const double reach_m = 300.0 / std::tan(std::numbers::pi / 6.0);  // 520 m west of the wall
    for (std::size_t v = 0; v < share.size(); ++v) {
        const double west_of_wall_m = 500.0 - mesh.positions[v].x;
        if (west_of_wall_m > 2 * kPost_m && west_of_wall_m < reach_m - 2 * kPost_m) {
            EXPECT_EQ(share[v], 0.0F) << v;
        } else if (west_of_wall_m > reach_m + 2 * kPost_m) {
            EXPECT_NEAR(share[v], 1.0F, 1e-6F) << v;
        }
    }
}

TEST(SunShare, FallsOffWithoutStairs) {
    // The shadow's edge lies askew to the posts; along it the share changes, but nowhere from all to nothing.
    const TerrainMesh mesh = heightfield(21, 21, kPost_m, [](double, double) { return 0.0; });
    const AreBlocked west_half = each([](Point<Scene> p, Vector<Scene>) { return p.x < 0.3 * p.y + 7.0; });
    const auto share = sun_share(mesh, {0.0, 0.0, 1.0}, west_half);
    int between = 0;
    for (std::size_t v = 0; v + 1 < share.size(); ++v) {
        if (v % 21 == 20) continue;
        EXPECT_LT(std::abs(share[v + 1] - share[v]), 0.9F) << v;
        between += share[v] > 0.0F && share[v] < 1.0F ? 1 : 0;
    }
    EXPECT_GE(between, 21);
}

TEST(SkyLight, AValleySeesLessOfTheSkyThanItsRim) {
    const TerrainMesh mesh = heightfield(41, 21, kPost_m, valley_m);
    const Daylight day(low_sun_in_the_east());
    const auto sky = sky_light(mesh, vertex_normals(mesh), day, blocked_by(valley_m));
    const SkyLight& floor = sky[10 * 41 + 20];
    const SkyLight& rim = sky[10 * 41 + 40];
    EXPECT_LT(brightness(floor.irradiance), 0.9F * brightness(day.sky()));
    EXPECT_GT(floor.ground_share, rim.ground_share);
    // Between slopes of 45 degrees a quarter turn of the sky is open: of a uniform sky sin 45 degrees of the
    // irradiance; this one is brighter low down, where the slopes are.
    EXPECT_LT(1.0F - floor.ground_share, std::sqrt(0.5F));
    EXPECT_GT(1.0F - floor.ground_share, 0.45F);
}

}  // namespace
}  // namespace overfly
