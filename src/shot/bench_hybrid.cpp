#include "shot/bench_hybrid.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "film/frame_error.h"
#include "shot/bench_scene.h"

namespace overfly {
namespace {

constexpr std::size_t kPieces = 4;
constexpr int kReferenceSamples = 1024;

// The hybrid's lines don't drift, so those that it is compared with don't either.
SamplingDocument sampling(const BenchScene& scene, TracerKind kind) {
    SamplingDocument asked = scene.shot().sampling;
    asked.tracer = kind;
    asked.drift_px = 0.0;
    return asked;
}

double share_by_lines(const Exposing& hybrid, const BenchWork& work) {
    std::vector<TimeRange> exposures;
    for (const PlannedFrame& f : hybrid.planned) {
        if (is_exposed_in(f, work.pieces.front())) exposures.push_back(f.exposure);
    }
    const std::vector<PixelTile> tiles = tiles_of(hybrid.size);
    TraceCounters counters;
    const PreparedSight prepared =
        hybrid.tracers.continuous->prepare(work.pieces.front().when, hybrid.size.film_bounds());
    const auto by_lines = std::ranges::count_if(tiles, [&](const PixelTile& tile) {
        const TileSamples lines = samples_of(tile, hybrid.size, hybrid.tracers.lines, hybrid.filter);
        return lines_are_cheaper(hybrid.tracers, prepared, lines.samples, exposures, counters);
    });
    return static_cast<double>(by_lines) / static_cast<double>(tiles.size());
}

// The tracers by turns, piece by piece, so that a change of the machine's speed meets all of them.
void time_tracers(const BenchScene& scene, std::span<const BenchWork> all_work, const Progress& progress,
                  HybridBench& result) {
    const OneThread one_thread;
    double pixel_frames = 0.0;
    for (std::size_t w = 0; w < all_work.size(); ++w) {
        if (progress) progress("timing the tracers", static_cast<double>(w), static_cast<double>(all_work.size()));
        const BenchWork& work = all_work[w];
        result.frames += static_cast<int>(work.frames.size());
        pixel_frames += static_cast<double>(work.frames.size()) * result.width * result.height;
        for (HybridTiming& timing : result.tracers) {
            const ShotTracers tracers = scene.tracers(sampling(scene, timing.kind));
            const Exposing exposing = scene.exposing(tracers);
            timing.ns_per_pixel_frame += 1e9 * expose(exposing, work).seconds;
            if (timing.kind == TracerKind::Hybrid)
                result.share_by_lines += share_by_lines(exposing, work) / static_cast<double>(all_work.size());
        }
    }
    for (HybridTiming& timing : result.tracers) timing.ns_per_pixel_frame /= pixel_frames;
}

// The error of one frame by each.
void compare_with_many(const BenchScene& scene, const BenchWork& work, const Progress& progress, HybridBench& result) {
    if (progress) progress("making the reference", 0.0, 0.0);
    const BenchWork one = {work.pieces, {work.frames.front()}};
    const auto frame_by = [&](TracerKind kind, int samples) {
        SamplingDocument asked = sampling(scene, kind);
        asked.samples = samples;
        const ShotTracers tracers = scene.tracers(asked);
        return std::move(expose(scene.exposing(tracers), one).frames.front());
    };
    const Frame reference = frame_by(TracerKind::Discrete, kReferenceSamples);
    for (HybridTiming& timing : result.tracers)
        timing.rmse = root_mean_square(frame_by(timing.kind, scene.shot().sampling.samples), reference);
}

}  // namespace

HybridBench bench_hybrid(const ShotDocument& shot, const BenchOptions& options) {
    const BenchScene scene(shot, options.cache_folder, options.progress);
    HybridBench result;
    result.width = shot.image.width;
    result.height = shot.image.height;
    result.lines = shot.sampling.lines;
    result.samples = shot.sampling.samples;
    result.reference_samples = kReferenceSamples;
    result.tracers = {{{TracerKind::Interval}, {TracerKind::Discrete}, {TracerKind::Hybrid}}};
    const std::vector<BenchWork> all_work = bench_work(scene, kPieces);
    time_tracers(scene, all_work, options.progress, result);
    compare_with_many(scene, all_work[all_work.size() / 2], options.progress, result);
    return result;
}

}  // namespace overfly
