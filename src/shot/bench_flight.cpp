#include "shot/bench_flight.h"

#include <algorithm>
#include <array>
#include <span>

#include "shot/expose_piece.h"
#include "shot/flight_scene.h"
#include "shot/processor_time.h"
#include "shot/shot_motion.h"
#include "shot/stage.h"

namespace overfly {
namespace {

constexpr std::size_t kPieces = 4;
constexpr std::size_t kEveryTile = 2;
constexpr std::array<std::size_t, 3> kSwollenPieces = {1, 4, 16};

// As in a render: the second sample of a pixel finds in the caches what the first has fetched.
constexpr int kSamplesPerPixel = 4;

struct Work {
    const MotionPiece& piece;
    std::vector<TimeRange> exposures;
    std::vector<TileSamples> tiles;

    [[nodiscard]] double pixel_frames() const {
        std::size_t pixels = 0;
        for (const TileSamples& t : tiles) pixels += t.samples.size();
        return static_cast<double>(pixels) * static_cast<double>(exposures.size());
    }
};

template <class AnyTracer>
double seconds_of(const AnyTracer& tracer, const Work& work, TraceCounters& counters) {
    SegmentLists lists;
    const double start_s = processor_seconds();
    for (const TileSamples& tile : work.tiles) {
        lists.clear();
        tracer.trace(work.piece, tile.samples, work.exposures, lists, counters);
    }
    return processor_seconds() - start_s;
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

}  // namespace

BenchResult bench_flight(const ShotDocument& shot, const BenchOptions& options) {
    Stage stage(prepare_terrain(shot.terrain, options.cache_folder, options.progress), middle_of(shot.flight));
    const CameraPath path = make_path(shot.flight, stage);
    const std::vector<PlannedFrame> frames = plan_frames(shot, path.times());
    const Motion motion = shot_motion(shot, path, frames, stage);
    fit_mesh_to_flight(stage, shot, path, options.cache_folder, options.progress);
    const DiscreteTracer discrete(stage.rays());
    const IntervalTracer interval(stage.mesh());
    BenchResult result;
    result.width = shot.image.width;
    result.height = shot.image.height;
    result.triangles = stage.mesh().triangles.size();
    const std::vector<TileSamples> tiles = some_tiles({shot.image.width, shot.image.height});
    double discrete_s = 0.0;
    double interval_s = 0.0;
    double pixel_frames = 0.0;
    const std::vector<MotionPiece> pieces = some_pieces(motion);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        if (options.progress)
            options.progress("timing the tracers", static_cast<double>(k), static_cast<double>(pieces.size()));
        Work work = {pieces[k], {}, tiles};
        for (const PlannedFrame& f : frames) {
            if (is_exposed_in(f, work.piece)) work.exposures.push_back(intersection(f.exposure, work.piece.when));
        }
        result.frames += static_cast<int>(work.exposures.size());
        pixel_frames += work.pixel_frames();
        discrete_s += seconds_of(discrete, work, result.discrete.counters);
        interval_s += seconds_of(interval, work, result.interval.counters);
    }
    result.discrete.ns_per_sample = 1e9 * discrete_s / pixel_frames;
    result.interval.ns_per_sample = 1e9 * interval_s / pixel_frames;
    const PictureSize size = {shot.image.width, shot.image.height};
    result.volumes = compare_volumes(stage.mesh(), interval, pieces, size, options.progress);
    for (const std::size_t count : kSwollenPieces) {
        if (count > motion.pieces.size()) break;
        const auto middle = std::span(motion.pieces).subspan((motion.pieces.size() - count) / 2, count);
        result.swollen.push_back(swollen_boxes(stage.mesh(), middle, size));
    }
    if (options.progress) options.progress("comparing the tracers", 0.0, 0.0);
    const AgreementOptions pairs = {options.agreement_pairs, 1, shot.image.width, shot.image.height};
    result.agreement = compare(discrete, interval, stage.mesh(), motion, pairs);
    return result;
}

}  // namespace overfly
