#include "shot/expose_piece.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "shot/drift_exposure.h"
#include "shot/tile_exposure.h"

namespace overfly {
namespace {

// Work in parts that threads take.
template <class Part, class Run>
void run_all(const Exposing& exposing, std::span<const Part> parts, const Run& run, TraceCounters& counters,
             const PieceProgress& progress) {
    std::mutex mutex;
    std::size_t done = 0;
    parallel_for(parts.size(), [&](std::size_t i) {
        if (exposing.should_stop && exposing.should_stop()) throw Interrupted();
        TraceCounters of_part;
        run(parts[i], of_part);
        const std::scoped_lock lock(mutex);
        counters += of_part;
        ++done;
        if (progress) progress(static_cast<double>(done) / static_cast<double>(parts.size()));
    });
}

// As many at a time as one sweep does for.
void expose_drifting(const Exposing& exposing, DriftExposure& exposure, std::span<const TimeRange> exposures,
                     std::span<FilmFrame* const> films, TraceCounters& counters, const PieceProgress& progress) {
    for (std::size_t first = 0; first < exposures.size();) {
        const std::size_t together = exposure.prepare(exposures.subspan(first), films.subspan(first));
        const std::vector<DriftExposure::Part> parts = exposure.parts();
        const auto run = [&](const DriftExposure::Part& part, TraceCounters& of_part) { exposure.run(part, of_part); };
        const auto some_done = [&](double share) {
            if (progress)
                progress((static_cast<double>(first) + share * static_cast<double>(together)) /
                         static_cast<double>(exposures.size()));
        };
        run_all(exposing, std::span<const DriftExposure::Part>(parts), run, counters, some_done);
        first += together;
    }
}

void expose_standing(const TilePreparation& prepared, std::span<const TimeRange> exposures,
                     std::span<FilmFrame* const> films, TraceCounters& counters, const PieceProgress& progress) {
    const Exposing& exposing = *prepared.exposing;
    std::vector<TileExposure> walks;
    if (prepared.is_kinetic) {
        for (Walk& walk : walks_through(prepared.planned, exposures))
            walks.emplace_back(prepared, exposures.subspan(walk.first, walk.count),
                               films.subspan(walk.first, walk.count), std::move(walk.traced));
    } else {
        walks.emplace_back(prepared, exposures, films, std::vector(exposures.begin(), exposures.end()));
    }
    std::vector<PixelTile> tiles = tiles_of(exposing.size);
    if (exposing.wanted)
        std::erase_if(tiles, [&](const PixelTile& tile) { return !exposing.wanted(tile.left, tile.top); });
    const auto run = [&](const PixelTile& tile, TraceCounters& of_tile) {
        for (const TileExposure& walk : walks) walk.run(tile, of_tile);
    };
    run_all(exposing, std::span<const PixelTile>(tiles), run, counters, progress);
}

}  // namespace

FrameSteps Exposing::steps_of(const PlannedFrame& frame) const {
    FrameSteps steps = {frame.lasts_s, frame.lasts_s, {}};
    const auto found = std::ranges::find(planned, frame.number, &PlannedFrame::number);
    if (found != planned.end() && found != planned.begin()) steps.previous_s = std::prev(found)->lasts_s;
    if (frame.exposure.duration_s() == 0.0) steps.instant_s = frame.exposure.begin_s;
    return steps;
}

bool is_exposed_in(const PlannedFrame& frame, const MotionPiece& piece) {
    if (frame.exposure.duration_s() == 0.0) {
        return piece.when.begin_s <= frame.exposure.begin_s && frame.exposure.begin_s < piece.when.end_s;
    }
    return intersection(frame.exposure, piece.when).duration_s() > 0.0;
}

std::vector<TimeRange> planned_exposures(const Exposing& exposing, const MotionPiece& piece) {
    std::vector<TimeRange> out;
    for (const PlannedFrame& f : exposing.planned) {
        if (is_exposed_in(f, piece)) out.push_back(f.exposure);
    }
    check(!out.empty(), "what is exposed was planned");
    return out;
}

PieceExposure::PieceExposure(const Exposing& exposing, const MotionPiece& piece) : exposing_(&exposing) {
    if (exposing.tracers.drift_px > 0.0) {
        drifting_ = std::make_unique<DriftExposure>(exposing, piece);
    } else {
        standing_ = std::make_unique<TilePreparation>(exposing, piece);
    }
}

PieceExposure::~PieceExposure() = default;

void PieceExposure::expose(std::span<const PlannedFrame> frames, std::span<FilmFrame* const> films,
                           TraceCounters& counters, const PieceProgress& progress) {
    std::vector<TimeRange> exposures;
    for (const PlannedFrame& f : frames) exposures.push_back(f.exposure);
    if (drifting_) return expose_drifting(*exposing_, *drifting_, exposures, films, counters, progress);
    expose_standing(*standing_, exposures, films, counters, progress);
}

void expose_piece(const Exposing& exposing, const MotionPiece& piece, std::span<const PlannedFrame> frames,
                  std::span<FilmFrame* const> films, TraceCounters& counters, const PieceProgress& progress) {
    PieceExposure(exposing, piece).expose(frames, films, counters, progress);
}

}  // namespace overfly
