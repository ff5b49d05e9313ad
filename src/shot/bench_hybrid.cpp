#include "shot/bench_hybrid.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "shot/expose_piece.h"
#include "shot/processor_time.h"
#include "shot/scene_light.h"
#include "shot/shot_motion.h"
#include "shot/shot_sight.h"
#include "shot/shot_tracers.h"

namespace overfly {
namespace {

constexpr std::size_t kPieces = 4;
constexpr int kReferenceSamples = 1024;

// A stretch of the shot, and the frames that are exposed in it.
struct Work {
    const MotionPiece& piece;
    std::vector<PlannedFrame> frames;
};

struct Exposed {
    std::vector<Frame> frames;
    double seconds = 0.0;
};

Exposed expose(const Exposing& exposing, const Work& work) {
    std::vector<FilmFrame> films;
    for (std::size_t k = 0; k < work.frames.size(); ++k) films.emplace_back(exposing.size.width, exposing.size.height);
    std::vector<FilmFrame*> pointers;
    for (FilmFrame& film : films) pointers.push_back(&film);
    TraceCounters counters;
    Exposed out;
    const double start_s = processor_seconds();
    expose_piece(exposing, work.piece, work.frames, pointers, counters);
    out.seconds = processor_seconds() - start_s;
    for (FilmFrame& film : films) out.frames.push_back(std::move(film).develop());
    return out;
}

// Of the differences of all colours of two pictures.
double root_mean_square(const Frame& a, const Frame& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = static_cast<double>(a.rgba[i][c]) - static_cast<double>(b.rgba[i][c]);
            sum += difference * difference;
        }
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(a.rgba.size())));
}

double share_by_lines(const Exposing& hybrid, const Work& work) {
    std::vector<TimeRange> exposures;
    for (const PlannedFrame& f : hybrid.planned) {
        if (is_exposed_in(f, work.piece)) exposures.push_back(f.exposure);
    }
    const std::vector<PixelTile> tiles = tiles_of(hybrid.size);
    TraceCounters counters;
    const PreparedSight prepared = hybrid.tracers.continuous->prepare(work.piece.when, hybrid.size.film_bounds());
    const auto by_lines = std::ranges::count_if(tiles, [&](const PixelTile& tile) {
        const TileSamples lines = samples_of(tile, hybrid.size, hybrid.tracers.lines);
        return lines_are_cheaper(hybrid.tracers, prepared, lines.samples, exposures, counters);
    });
    return static_cast<double>(by_lines) / static_cast<double>(tiles.size());
}

// One thread while it lives.
class OneThread {
  public:
    OneThread() : before_(thread_limit()) { limit_threads(1); }
    ~OneThread() { limit_threads(before_); }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

  private:
    int before_;
};

// What all tracers have before them.
struct HybridScene {
    const ShotDocument& shot;
    const Stage& stage;
    const ShotBodies& bodies;
    const Sight& sight;
    SceneShader shader;
    std::span<const PlannedFrame> planned;

    [[nodiscard]] ShotTracers tracers(TracerKind kind, int samples) const {
        ShotDocument asked = shot;
        asked.sampling.tracer = kind;
        asked.sampling.samples = samples;
        return {asked, stage, bodies, sight};
    }
    [[nodiscard]] Exposing exposing(const ShotTracers& tracers_of_it) const {
        return {tracers_of_it.pair(), shader, {shot.image.width, shot.image.height}, {}, planned};
    }
};

// The pieces of the shot that are measured: evenly spread over those with a frame in them.
std::vector<Work> work_of(const Motion& motion, const std::vector<PlannedFrame>& frames) {
    std::vector<const MotionPiece*> exposed;
    for (const MotionPiece& piece : motion.pieces) {
        if (std::ranges::any_of(frames, [&](const PlannedFrame& f) { return is_exposed_in(f, piece); }))
            exposed.push_back(&piece);
    }
    std::vector<Work> out;
    const std::size_t pieces = std::min(kPieces, exposed.size());
    for (std::size_t k = 0; k < pieces; ++k) {
        Work work = {*exposed[(2 * k + 1) * exposed.size() / (2 * pieces)], {}};
        for (const PlannedFrame& f : frames) {
            if (!is_exposed_in(f, work.piece)) continue;
            work.frames.push_back(f);
            work.frames.back().exposure = intersection(f.exposure, work.piece.when);
        }
        out.push_back(std::move(work));
    }
    return out;
}

// The tracers by turns, piece by piece, so that a change of the machine's speed meets all of them.
void time_tracers(const HybridScene& scene, std::span<const Work> all_work, const Progress& progress,
                  HybridBench& result) {
    const OneThread one_thread;
    double pixel_frames = 0.0;
    for (std::size_t w = 0; w < all_work.size(); ++w) {
        if (progress) progress("timing the tracers", static_cast<double>(w), static_cast<double>(all_work.size()));
        const Work& work = all_work[w];
        result.frames += static_cast<int>(work.frames.size());
        pixel_frames += static_cast<double>(work.frames.size()) * result.width * result.height;
        for (HybridTiming& timing : result.tracers) {
            const ShotTracers tracers = scene.tracers(timing.kind, scene.shot.sampling.samples);
            const Exposing exposing = scene.exposing(tracers);
            timing.ns_per_pixel_frame += 1e9 * expose(exposing, work).seconds;
            if (timing.kind == TracerKind::Hybrid)
                result.share_by_lines += share_by_lines(exposing, work) / static_cast<double>(all_work.size());
        }
    }
    for (HybridTiming& timing : result.tracers) timing.ns_per_pixel_frame /= pixel_frames;
}

// The error of one frame by each.
void compare_with_many(const HybridScene& scene, const Work& work, const Progress& progress, HybridBench& result) {
    if (progress) progress("making the reference", 0.0, 0.0);
    const Work one = {work.piece, {work.frames.front()}};
    const auto frame_by = [&](TracerKind kind, int samples) {
        const ShotTracers tracers = scene.tracers(kind, samples);
        return std::move(expose(scene.exposing(tracers), one).frames.front());
    };
    const Frame reference = frame_by(TracerKind::Discrete, kReferenceSamples);
    for (HybridTiming& timing : result.tracers)
        timing.rmse = root_mean_square(frame_by(timing.kind, scene.shot.sampling.samples), reference);
}

}  // namespace

HybridBench bench_hybrid(const ShotDocument& shot, const BenchOptions& options) {
    const Stage stage(prepare_terrain(shot.terrain, options.cache_folder, options.progress), middle_of(shot.flight));
    const CameraPath path = make_path(shot.flight, stage);
    const std::vector<PlannedFrame> frames = plan_frames(shot, path.times());
    const ShotBodies bodies = make_bodies(shot, stage);
    const Daylight day(shot.look.look);
    const Sight sight = make_sight(shot, path, shot_motion(shot, path, frames, stage), {stage, bodies, day.to_sun()});
    const SceneLight light(shot, stage, day, options.progress);
    const HybridScene scene = {shot, stage, bodies, sight, light.shader(bodies), frames};
    HybridBench result;
    result.width = shot.image.width;
    result.height = shot.image.height;
    result.lines = shot.sampling.lines;
    result.samples = shot.sampling.samples;
    result.reference_samples = kReferenceSamples;
    result.tracers = {{{TracerKind::Interval}, {TracerKind::Discrete}, {TracerKind::Hybrid}}};
    const std::vector<Work> all_work = work_of(sight.motions.front(), frames);
    time_tracers(scene, all_work, options.progress, result);
    compare_with_many(scene, all_work[all_work.size() / 2], options.progress, result);
    return result;
}

}  // namespace overfly
