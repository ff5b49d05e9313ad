#include "shot/expose_piece.h"

#include <mutex>

#include "core/parallel.h"
#include "film/integrate.h"

namespace overfly {
namespace {

class TileExposure {
  public:
    TileExposure(const Exposing& exposing, const MotionPiece& piece, std::span<const TimeRange> exposures,
                 std::span<FilmFrame* const> films)
        : exposing_(&exposing), piece_(&piece), exposures_(exposures), films_(films) {}

    void run(const PixelTile& tile, TraceCounters& counters) const {
        const TileSamples tiled = samples_of(tile, exposing_->size, exposing_->samples_per_pixel);
        SegmentLists lists;
        trace(exposing_->tracer, *piece_, tiled.samples, exposures_, lists, counters);
        const bool instants = std::holds_alternative<DiscreteTracer>(exposing_->tracer);
        for (std::size_t i = 0; i < tiled.samples.size(); ++i) {
            const Deposit deposit = {this, &tiled.samples[i], tiled.pixels[i]};
            if (instants) {
                integrate_instants(lists.of(i), exposures_, [&](const VisibleSegment& s, std::size_t e, double t) {
                    deposit(e, s.triangle, t, 1.0);
                });
                continue;
            }
            for (std::size_t e = 0; e < exposures_.size(); ++e) {
                const auto stretch = [&](const VisibleSegment* s, double t, double share) {
                    deposit(e, s != nullptr ? s->triangle : kNone, t, share);
                };
                integrate(lists.of(i), piece_->when, exposures_[e], stretch);
            }
        }
    }

  private:
    // Adds what one sample sees at a time to its pixel.
    struct Deposit {
        const TileExposure* tile;
        const ImageSample* sample;
        std::uint32_t pixel;

        void operator()(std::size_t exposure, TriangleId triangle, double time_s, double share) const {
            const double weight = share / tile->exposing_->samples_per_pixel;
            const Radiance seen =
                tile->exposing_->shader.radiance(*tile->piece_, sample->x, sample->y, triangle, time_s);
            tile->films_[exposure]->add(pixel, static_cast<float>(weight), seen);
        }
    };

    const Exposing* exposing_;
    const MotionPiece* piece_;
    std::span<const TimeRange> exposures_;
    std::span<FilmFrame* const> films_;
};

}  // namespace

bool is_exposed_in(const PlannedFrame& frame, const MotionPiece& piece) {
    if (frame.exposure.duration_s() == 0.0) {
        return piece.when.begin_s <= frame.exposure.begin_s && frame.exposure.begin_s < piece.when.end_s;
    }
    return intersection(frame.exposure, piece.when).duration_s() > 0.0;
}

void expose_piece(const Exposing& exposing, const MotionPiece& piece, std::span<const PlannedFrame> frames,
                  std::span<FilmFrame* const> films, TraceCounters& counters, const PieceProgress& progress) {
    std::vector<TimeRange> exposures;
    for (const PlannedFrame& f : frames) exposures.push_back(f.exposure);
    const TileExposure exposure(exposing, piece, exposures, films);
    const std::vector<PixelTile> tiles = tiles_of(exposing.size);
    std::mutex mutex;
    std::size_t done = 0;
    parallel_for(tiles.size(), [&](std::size_t i) {
        if (exposing.should_stop && exposing.should_stop()) throw Interrupted();
        TraceCounters tile_counters;
        exposure.run(tiles[i], tile_counters);
        const std::scoped_lock lock(mutex);
        counters += tile_counters;
        ++done;
        if (progress) progress(static_cast<double>(done) / static_cast<double>(tiles.size()));
    });
}

}  // namespace overfly
