#include "shade/sky_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <tuple>

#include "core/error.h"
#include "core/low_discrepancy.h"
#include "shade/parallel_blocks.h"
#include "shade/raster_bands.h"
#include "shade/sky_block.h"

namespace overfly {
namespace {

constexpr int kAveragings = 2;  // they bring together what the sets see
constexpr std::uint64_t kSeed = 1991;

// Each set alone lights level ground by day.sky() exactly.
SkySets sky_sets(const Daylight& day) {
    SkySets sets;
    for (std::uint32_t i = 0; i < kSkySets * std::tuple_size_v<SkySet>; ++i) {
        const auto p = low_discrepancy_point(kSeed, i);
        const double level = std::sqrt(1.0 - p[0] * p[0]);
        const double turn = 2.0 * std::numbers::pi * p[1];
        const Vector<Scene> towards = {level * std::cos(turn), level * std::sin(turn), p[0]};
        sets[i % kSkySets][i / kSkySets] = {towards, day.background(towards, {0.0, 0.0, 1.0})};
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

std::vector<SkyLight> sky_light(const TerrainMesh& mesh, std::span<const Vector<Scene>> normals, const Daylight& day,
                                const AreBlocked& are_blocked, const Progress& progress) {
    check(mesh.samples.size() == mesh.positions.size(), "each vertex has its sample");
    const SkySets sets = sky_sets(day);
    std::vector<SkyLight> light(mesh.positions.size());
    std::vector<float> open(light.size());  // share of the sky's light on this slope that no ground keeps off
    const std::vector<std::size_t> bands = band_starts(mesh.samples);
    parallel_tasks(bands.size() - 1, "skylight", progress, [&](std::size_t band) {
        const std::vector<VertexId> vertices = by_columns(mesh.samples, bands[band], bands[band + 1]);
        for (std::size_t first = 0; first < vertices.size(); first += SkyBlock::kSize) {
            const auto some = std::span(vertices).subspan(first, std::min(SkyBlock::kSize, vertices.size() - first));
            const SkyBlock block(mesh, normals, some);
            const auto unhindered = block.unhindered(sets);
            for (std::size_t i = 0; i < some.size(); ++i) light[some[i]].irradiance = unhindered[i];
            for (std::uint32_t set = 0; set < kSkySets; ++set) block.find_open(sets, set, are_blocked, open);
        }
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
