#include "shot/memory_plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "core/parallel.h"
#include "film/film_frame.h"
#include "film/quantities.h"
#include "shot/frame_loop.h"

namespace overfly {
namespace {

constexpr double kMegabyte = 1e6, kGigabyte = 1e9;

// Measured, by renders of the demo with all of its triangles, with those for its flight, in three sizes, and of the
// largest shot; as the resident set of the whole process, freed memory that is not given back included.
constexpr double kProgram_bytes = 150e6;
constexpr double kMakingPerTriangle = 185.0;
constexpr double kMakingPerTriangleOfHugeMesh = 135.0;  // Embree is asked to be compact (trace/ray_scene.cpp)
constexpr std::size_t kHugeMesh = 8'000'000;
constexpr double kLightPerSample = 32.0;
// Kept: GroundFacts. While they are made there are vertex_normals, the parts of light, and copies on the way as well.
constexpr double kFactPerSample = 16.0, kMakingFactsPerSample = 100.0;
constexpr double kKeptPerTriangle = 230.0;
constexpr double kHierarchyPerTriangle = 80.0;
constexpr double kPerBodyTriangle = 400.0;
constexpr double kSilhouettesPerPixel = 50.0;

std::size_t ground_facts_of(LayerSet layers) {
    const Quantities told(layers);
    const bool of_sunlight = told.has(Quantity::Direct) || told.has(Quantity::Shadow);
    return static_cast<std::size_t>(told.has(Quantity::Normal)) +
           static_cast<std::size_t>(told.has(Quantity::Geodetic)) +
           static_cast<std::size_t>(told.has(Quantity::Albedo)) + static_cast<std::size_t>(of_sunlight);
}

// Two digits, upwards: an allowance of what is said is enough.
std::string gigabytes(double bytes) {
    constexpr double kSteps = 100.0;
    return fmt::format("{:.2f}", std::ceil(bytes / kGigabyte * kSteps) / kSteps);
}

}  // namespace

SceneSizes sizes_of(const ShotDocument& shot, const Stage& stage, const ShotBodies& bodies) {
    SceneSizes sizes;
    sizes.full_triangles = stage.full_mesh().triangles.size();
    sizes.samples = stage.full_mesh().positions.size();
    sizes.triangles = stage.mesh().triangles.size();
    sizes.pixels = static_cast<std::size_t>(shot.image.width) * static_cast<std::size_t>(shot.image.height);
    sizes.has_hierarchy =
        shot.sampling.tracer != TracerKind::Kinetic || !bodies.empty() || shot.look.sun_shadows == SunShadows::Exact;
    sizes.ground_facts = ground_facts_of(shot.layers);
    for (const auto& body : bodies) sizes.body_triangles += body->mesh().triangles.size();
    return sizes;
}

SceneMemory scene_memory(const SceneSizes& sizes) {
    const auto full = static_cast<double>(sizes.full_triangles);
    const double making = sizes.full_triangles > kHugeMesh ? kMakingPerTriangleOfHugeMesh : kMakingPerTriangle;
    const auto samples = static_cast<double>(sizes.samples);
    const double facts_bytes = kFactPerSample * static_cast<double>(sizes.ground_facts) * samples;
    const double making_facts_bytes = sizes.ground_facts > 0 ? kMakingFactsPerSample * samples + facts_bytes : 0.0;
    const double per_triangle = kKeptPerTriangle + (sizes.has_hierarchy ? kHierarchyPerTriangle : 0.0);
    const double bodies_bytes = kPerBodyTriangle * static_cast<double>(sizes.body_triangles);
    return {kProgram_bytes + making * full + making_facts_bytes + bodies_bytes,
            kProgram_bytes + kLightPerSample * samples + facts_bytes +
                per_triangle * static_cast<double>(sizes.triangles) + bodies_bytes +
                kSilhouettesPerPixel * static_cast<double>(sizes.pixels)};
}

double MemoryPlan::bytes_with(std::size_t films) const {
    const auto written = std::min(static_cast<std::size_t>(threads), films);
    return std::max(scene.making_bytes, scene.kept_bytes + static_cast<double>(films + written) * frame_bytes);
}

std::string MemoryPlan::text() const {
    return fmt::format("memory: {} GB for the scene, {:.1f} MB a frame, {} frames at once, of {} GB",
                       gigabytes(std::max(scene.making_bytes, scene.kept_bytes)), frame_bytes / kMegabyte, frames,
                       allowed_bytes / kGigabyte);
}

MemoryPlan plan_memory(const ShotDocument& shot, const SceneMemory& scene, const FramesInMemory& frames) {
    MemoryPlan plan = {scene, static_cast<double>(frames.frame_bytes), shot.memory_gb * kGigabyte, frames.threads,
                       kFewestFilms};
    const double least_bytes = plan.bytes_with(kFewestFilms);
    if (least_bytes > plan.allowed_bytes) {
        throw UserError(
            {shot.file},
            fmt::format("memory_gb: got {}, but {} is the least: {} GB for the scene, and two frames of {:.1f} MB "
                        "and what writing them takes",
                        shot.memory_gb, gigabytes(least_bytes),
                        gigabytes(std::max(scene.making_bytes, scene.kept_bytes)), plan.frame_bytes / kMegabyte));
    }
    while (plan.frames < frames.most && plan.bytes_with(plan.frames + 1) <= plan.allowed_bytes) ++plan.frames;
    return plan;
}

void require_memory(const ShotDocument& shot, const Stage& stage, const ShotBodies& bodies) {
    SceneSizes sizes = sizes_of(shot, stage, bodies);
    sizes.triangles = 0;
    const std::size_t frame_bytes =
        FilmFrame::memory_bytes(shot.image.width, shot.image.height, FilmFrame::Weights::AddUp, FactKinds(shot.layers));
    static_cast<void>(plan_memory(shot, scene_memory(sizes), {frame_bytes, thread_limit(), kFewestFilms}));
}

}  // namespace overfly
