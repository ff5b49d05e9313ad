#include "shot/bench_flight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <thread>

#include "core/error.h"
#include "core/stopwatch.h"
#include "io/frame_file.h"
#include "shot/frame_loop.h"
#include "shot/processor_time.h"
#include "shot/scratch_folder.h"
#include "shot/shot_motion.h"
#include "shot/tile_exposure.h"

namespace overfly {
namespace {

constexpr std::size_t kPieces = 4;
constexpr std::size_t kEveryTile = 2;
constexpr std::array<std::size_t, 3> kSwollenPieces = {1, 4, 16};

// As in a render: the second sample of a pixel finds in the caches what the first has fetched.
constexpr int kSamplesPerPixel = 4;

// Of a frame that goes into a file, and how often that is written: the quickest counts.
constexpr int kLinesToTheEnd = 4, kWritingRuns = 3;

struct Work {
    const MotionPiece& piece;
    std::vector<TimeRange> exposures;
    std::span<const TileSamples> tiles;

    [[nodiscard]] double samples() const {
        std::size_t count = 0;
        for (const TileSamples& t : tiles) count += t.samples.size();
        return static_cast<double>(count);
    }
    [[nodiscard]] double pixel_frames() const { return samples() * static_cast<double>(exposures.size()); }
};

template <class Trace>
double seconds_of(const Work& work, const Trace& trace) {
    SegmentLists lists;
    const double start_s = processor_seconds();
    for (const TileSamples& tile : work.tiles) {
        lists.clear();
        trace(tile, lists);
    }
    return processor_seconds() - start_s;
}

template <class AnyTracer>
double seconds_of(const AnyTracer& tracer, const Work& work, TraceCounters& counters) {
    return seconds_of(work, [&](const TileSamples& tile, SegmentLists& lists) {
        tracer.trace(work.piece, tile.samples, work.exposures, lists, counters);
    });
}

// A piece is prepared once for all pixels, of which these are some. Frames go by in windows, as in a render with so
// many films.
double kinetic_seconds(const KineticTracer& tracer, const Work& work, const PictureSize& size, std::size_t films,
                       TraceCounters& counters) {
    const double start_s = processor_seconds();
    const KineticPiece piece = tracer.prepare(work.piece, size.film_bounds());
    const double prepare_s = processor_seconds() - start_s;
    const std::span<const TimeRange> all = work.exposures;
    const std::size_t windows = windows_of(all.size(), films);
    double trace_s = 0.0;
    for (std::size_t k = 0; k < windows; ++k) {
        const std::size_t begin = all.size() * k / windows, end = all.size() * (k + 1) / windows;
        for (const Walk& walk : walks_through(all, all.subspan(begin, end - begin))) {
            trace_s += seconds_of(work, [&](const TileSamples& tile, SegmentLists& lists) {
                tracer.trace(piece, tile.samples, walk.traced, lists, counters);
            });
        }
    }
    return trace_s + prepare_s * work.samples() / (static_cast<double>(size.width) * size.height);
}

// In one window.
double kinetic_seconds(const KineticTracer& tracer, const Work& work, const PictureSize& size,
                       TraceCounters& counters) {
    return kinetic_seconds(tracer, work, size, std::max(2 * work.exposures.size(), kFewestFilms), counters);
}

std::vector<TileSamples> some_tiles(PictureSize size) {
    std::vector<TileSamples> out;
    const std::vector<PixelTile> tiles = tiles_of(size);
    for (std::size_t i = 0; i < tiles.size(); i += kEveryTile)
        out.push_back(samples_of(tiles[i], size, kSamplesPerPixel));
    return out;
}

// Evenly over the flight.
std::vector<MotionPiece> some_pieces(const Motion& motion) {
    std::vector<MotionPiece> out;
    const std::size_t count = std::min(kPieces, motion.pieces.size());
    for (std::size_t k = 0; k < count; ++k)
        out.push_back(motion.pieces[(2 * k + 1) * motion.pieces.size() / (2 * count)]);
    return out;
}

std::vector<TimeRange> exposures_in(std::span<const PlannedFrame> frames, const MotionPiece& piece) {
    std::vector<TimeRange> out;
    for (const PlannedFrame& f : frames) {
        if (is_exposed_in(f, piece)) out.push_back(intersection(f.exposure, piece.when));
    }
    return out;
}

class FlightBench {
  public:
    FlightBench(const BenchScene& scene, const BenchOptions& options)
        : scene_(&scene), options_(&options), tiles_(some_tiles(scene.size())), pieces_(some_pieces(scene.motion())) {}

    BenchResult run() {
        result_.width = scene_->size().width;
        result_.height = scene_->size().height;
        result_.full_triangles = scene_->mesh().triangles_before;
        result_.timed_pieces = pieces_.size();
        result_.triangles = scene_->stage().mesh().triangles.size();
        {
            const OneThread one_thread;
            time_tracers();
            time_frame_rates();
        }
        compare_boxes();
        compare_answers();
        time_threads();
        result_.error = bench_error(*scene_, options_->progress);
        time_end_to_end();
        return std::move(result_);
    }

  private:
    void time_tracers() {
        const DiscreteTracer discrete(scene_->stage().rays());
        const IntervalTracer interval(scene_->stage().mesh());
        const KineticTracer kinetic(scene_->stage().rays());
        double pixel_frames = 0.0;
        for (const MotionPiece& piece : pieces_) {
            say("timing the tracers");
            const Work work = {piece, exposures_in(scene_->frames(), piece), tiles_};
            result_.frames += static_cast<int>(work.exposures.size());
            pixel_frames += work.pixel_frames();
            result_.discrete.ns_per_sample += 1e9 * seconds_of(discrete, work, result_.discrete.counters);
            result_.interval.ns_per_sample += 1e9 * seconds_of(interval, work, result_.interval.counters);
            result_.kinetic.ns_per_sample +=
                1e9 * kinetic_seconds(kinetic, work, scene_->size(), result_.kinetic.counters);
        }
        for (TracerTiming* timing : {&result_.discrete, &result_.interval, &result_.kinetic})
            timing->ns_per_sample /= pixel_frames;
    }

    // The same stretch of the flight by frames that follow each other more quickly.
    void time_frame_rates() {
        const KineticTracer kinetic(scene_->stage().rays());
        const TimeRange stretch = scene_->motion().times();
        const TimeRange middle = {stretch.centre_s() - 1.0 / 6.0, stretch.centre_s() + 1.0 / 6.0};
        for (const int factor : {1, 2, 5, 10}) {
            say("timing frame rates");
            ShotDocument shot = scene_->shot();
            shot.frames.rate.numerator *= factor;
            if (shot.frames.count) *shot.frames.count *= factor;
            const std::vector<PlannedFrame> frames = plan_frames(shot, scene_->path().times());
            const Motion motion = shot_motion(shot, scene_->path(), frames, scene_->stage());
            const std::size_t films = scene_->films(motion, frames);
            double seconds = 0.0, flight_s = 0.0, samples = 0.0;
            for (const MotionPiece& piece : motion.pieces_over(middle)) {
                const Work work = {piece, exposures_in(frames, piece), tiles_};
                if (work.exposures.empty()) continue;
                TraceCounters counters;
                seconds += kinetic_seconds(kinetic, work, scene_->size(), films, counters);
                flight_s += piece.when.duration_s();
                samples = work.samples();
            }
            result_.frame_rate_cost.push_back({factor, 1e9 * seconds / (flight_s * samples)});
        }
    }

    void compare_boxes() {
        const IntervalTracer interval(scene_->stage().mesh());
        result_.volumes =
            compare_volumes(scene_->stage().mesh(), interval, pieces_, scene_->size(), options_->progress);
        const std::span<const MotionPiece> all = scene_->motion().pieces;
        for (const std::size_t count : kSwollenPieces) {
            if (count > all.size()) break;
            result_.swollen.push_back(
                swollen_boxes(scene_->stage().mesh(), all.subspan((all.size() - count) / 2, count), scene_->size()));
        }
    }

    void compare_answers() {
        say("comparing the tracers");
        const RayScene& rays = scene_->stage().rays();
        const AgreementOptions pairs = {options_->agreement_pairs, 1, scene_->size().width, scene_->size().height};
        result_.agreement = compare(DiscreteTracer(rays), IntervalTracer(scene_->stage().mesh()),
                                    scene_->stage().mesh(), scene_->motion(), pairs);
        // About as many pairs, of as many of the lines as that takes.
        double lines = 0.0;
        for (const TileSamples& t : tiles_) lines += static_cast<double>(t.samples.size() * pieces_.size());
        const auto every = static_cast<std::uint64_t>(
            std::max(std::floor(lines / static_cast<double>(options_->agreement_pairs)), 1.0));
        const KineticTracer kinetic(rays, TraceCheck(rays, every, scene_->size().width));
        for (const MotionPiece& piece : pieces_) {
            const Work work = {piece, {piece.when}, tiles_};
            (void)kinetic_seconds(kinetic, work, scene_->size(), result_.kinetic_check);
        }
    }

    void time_threads() {
        const BenchWork work = bench_work(*scene_, 1).front();
        SamplingDocument sampling = scene_->shot().sampling;
        sampling.tracer = TracerKind::Kinetic;
        const ShotTracers tracers = scene_->tracers(sampling);
        const int before = thread_limit();
        const int most = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
        for (int threads = 1; threads <= most; threads *= 2) {
            say("timing threads");
            limit_threads(threads);
            const Stopwatch watch;
            (void)expose(scene_->exposing(tracers), work);
            result_.threads.push_back({threads, watch.seconds()});
        }
        limit_threads(before);
    }

    void time_end_to_end() {
        say("timing a frame with its file");
        const OneThread one_thread;
        SamplingDocument sampling = scene_->shot().sampling;
        sampling.tracer = TracerKind::Kinetic;
        sampling.lines = kLinesToTheEnd;
        const ShotTracers tracers = scene_->tracers(sampling);
        const BenchWork work = middle_frame(*scene_);
        const Exposed exposed = expose(scene_->exposing(tracers), work);
        FrameHeader header;
        header.camera = scene_->path().pose_at(work.frames.front().exposure.centre_s());
        const ScratchFolder scratch;
        const auto exposing =
            std::ranges::find(result_.error.kinetic, kLinesToTheEnd, [](const ErrorPoint& p) { return p.count; });
        check(exposing != result_.error.kinetic.end(), "so many lines have been timed");
        result_.end_to_end = {kLinesToTheEnd, exposing->seconds, std::numeric_limits<double>::infinity()};
        for (int run = 0; run < kWritingRuns; ++run) {
            const double start_s = processor_seconds();
            write_frame(scratch.file(), exposed.frames.front(), header, scene_->shot().output.storage);
            result_.end_to_end.write_s = std::min(result_.end_to_end.write_s, processor_seconds() - start_s);
        }
    }

    void say(std::string_view what) const {
        if (options_->progress) options_->progress(what, 0.0, 0.0);
    }

    const BenchScene* scene_;
    const BenchOptions* options_;
    std::vector<TileSamples> tiles_;
    std::vector<MotionPiece> pieces_;
    BenchResult result_;
};

}  // namespace

BenchResult bench_flight(const ShotDocument& shot, const BenchOptions& options) {
    const BenchScene scene(shot, options.cache_folder, options.progress);
    return FlightBench(scene, options).run();
}

}  // namespace overfly
