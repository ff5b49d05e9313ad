#include "shade/sky_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "core/low_discrepancy.h"
#include "shade/local_frame.h"
#include "shade/parallel_blocks.h"

namespace overfly {
namespace {

// Neighbouring vertices look into different ones of kSets * kRays directions; the averaging brings them together.
constexpr std::uint32_t kSets = 4;
constexpr std::uint32_t kRays = 24;
constexpr int kAveragings = 2;
constexpr std::uint64_t kSeed = 1991;

constexpr double kLift_m = 1.0;  // of the rays' origins: clear of float rounding within some 100 km

// Directions spread evenly over the half of space around z, and the light that comes from each.
struct SkyDirection {
    Vector<Scene> towards;
    Rgb radiance;
};
using SkySet = std::array<SkyDirection, kRays>;

float brightness(Rgb c) { return 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b; }  // Rec. 709 luminance

// Each set alone lights level ground by day.sky() exactly.
std::array<SkySet, kSets> sky_sets(const Daylight& day) {
    std::array<SkySet, kSets> sets;
    for (std::uint32_t i = 0; i < kSets * kRays; ++i) {
        const auto p = low_discrepancy_point(kSeed, i);
        const double level = std::sqrt(1.0 - p[0] * p[0]);
        const double turn = 2.0 * std::numbers::pi * p[1];
        const Vector<Scene> towards = {level * std::cos(turn), level * std::sin(turn), p[0]};
        sets[i % kSets][i / kSets] = {towards, day.background(towards, {0.0, 0.0, 1.0})};
    }
    for (SkySet& set : sets) {
        Rgb sum;
        for (const SkyDirection& d : set) sum += static_cast<float>(d.towards.z) * d.radiance;
        const Rgb whole = day.sky();
        const auto scale = [](float want, float have) { return have > 0.0F ? want / have : 0.0F; };
        const Rgb factor = {scale(whole.r, sum.r), scale(whole.g, sum.g), scale(whole.b, sum.b)};
        for (SkyDirection& d : set) d.radiance = factor * d.radiance;
    }
    return sets;
}

std::uint32_t set_of(std::size_t vertex) { return (static_cast<std::uint32_t>(vertex) * 2654435761U) >> 30U; }

// Each value becomes the mean of itself and its neighbours' mean along the sides of the triangles.
std::vector<float> averaged(const TriangleMesh& mesh, const std::vector<float>& values) {
    std::vector<float> sum(values.size(), 0.0F);
    std::vector<float> count(values.size(), 0.0F);
    for (const auto& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            sum[t[k]] += values[t[(k + 1) % 3]] + values[t[(k + 2) % 3]];
            count[t[k]] += 2.0F;
        }
    }
    for (std::size_t v = 0; v < sum.size(); ++v) {
        sum[v] = count[v] > 0.0F ? 0.5F * (values[v] + sum[v] / count[v]) : values[v];
    }
    return sum;
}

}  // namespace

std::vector<SkyLight> sky_light(const TriangleMesh& mesh, std::span<const Vector<Scene>> normals, const Daylight& day,
                                const IsBlocked& is_blocked, const Progress& progress) {
    static_assert(kSets == 4, "set_of");
    const std::array<SkySet, kSets> sets = sky_sets(day);
    std::vector<SkyLight> light(mesh.positions.size());
    std::vector<float> open(light.size());  // share of the sky's light on this slope that no ground keeps off
    parallel_blocks(light.size(), "skylight", progress, [&](std::size_t v) {
        const LocalFrame f = frame_around(up_at(mesh.positions[v]));
        const Point<Scene> from = mesh.positions[v] + kLift_m * normals[v];
        const Vector<Scene> n = {dot(normals[v], f.x), dot(normals[v], f.y), dot(normals[v], f.z)};
        Rgb unhindered;
        float all = 0.0F;
        float reaching = 0.0F;
        for (std::uint32_t s = 0; s < kSets; ++s) {
            for (const SkyDirection& d : sets[s]) {
                const double facing = dot(n, d.towards);
                if (facing <= 0.0) continue;
                const Rgb from_there = static_cast<float>(facing) * d.radiance;
                unhindered += (1.0F / kSets) * from_there;
                if (s != set_of(v)) continue;
                const float share = brightness(from_there);
                all += share;
                const Vector<Scene> direction = d.towards.x * f.x + d.towards.y * f.y + d.towards.z * f.z;
                if (!is_blocked(from, direction)) reaching += share;
            }
        }
        light[v].irradiance = unhindered;
        open[v] = all > 0.0F ? reaching / all : 1.0F;
    });
    for (int i = 0; i < kAveragings; ++i) open = averaged(mesh, open);
    for (std::size_t v = 0; v < light.size(); ++v) {
        // A slope sees (1 + cos) / 2 of a sky without mountains.
        const auto above = static_cast<float>(0.5 * (1.0 + dot(normals[v], up_at(mesh.positions[v]))));
        light[v].irradiance = open[v] * light[v].irradiance;
        light[v].ground_share = 1.0F - open[v] * above;
    }
    return light;
}

}  // namespace overfly
