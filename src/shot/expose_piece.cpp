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
        : exposing_(&exposing), piece_(&piece), exposures_(exposures), films_(films) {
        const TracerPair& tracers = exposing.tracers;
        const FilmBounds picture = exposing.size.film_bounds();
        if (tracers.continuous != nullptr) prepared_lines_ = tracers.continuous->prepare(piece.when, picture);
        if (tracers.discrete != nullptr) prepared_samples_ = tracers.discrete->prepare(piece.when, picture);
        for (const PlannedFrame& f : exposing.planned) {
            if (is_exposed_in(f, piece)) planned_.push_back(f.exposure);
        }
    }

    void run(const PixelTile& tile, TraceCounters& counters) const {
        const TracerPair& tracers = exposing_->tracers;
        if (tracers.continuous == nullptr) return sample(tile, exposures_, counters);
        const TileSamples lines = samples_of(tile, exposing_->size, tracers.lines);
        if (tracers.discrete == nullptr ||
            lines_are_cheaper(tracers, prepared_lines_, lines.samples, planned_, counters)) {
            return follow(lines, counters);
        }
        // The exposures' parts in this piece, each of which counts for its share: the rest may be followed.
        std::vector<TimeRange> parts;
        for (const TimeRange& e : exposures_) parts.push_back(intersection(e, piece_->when));
        sample(tile, parts, counters);
    }

  private:
    void follow(const TileSamples& lines, TraceCounters& counters) const {
        SurfaceSegmentLists lists;
        exposing_->tracers.continuous->trace(prepared_lines_, lines.samples, exposures_, lists, counters);
        for (std::size_t i = 0; i < lines.samples.size(); ++i) {
            const Deposit deposit = {this, &lines.samples[i], lists.reflected, lines.pixels[i],
                                     1.0 / exposing_->tracers.lines};
            for (std::size_t e = 0; e < exposures_.size(); ++e) {
                const auto stretch = [&](const SurfaceSegment* s, double t, double share) { deposit(e, s, t, share); };
                integrate(lists.of(i), piece_->when, exposures_[e], stretch);
            }
        }
    }

    // sampled: the exposures, or parts of them.
    void sample(const PixelTile& tile, std::span<const TimeRange> sampled, TraceCounters& counters) const {
        const TileSamples tiled = samples_of(tile, exposing_->size, exposing_->tracers.samples);
        SurfaceSegmentLists lists;
        exposing_->tracers.discrete->trace(prepared_samples_, tiled.samples, sampled, lists, counters);
        for (std::size_t i = 0; i < tiled.samples.size(); ++i) {
            const Deposit deposit = {this, &tiled.samples[i], lists.reflected, tiled.pixels[i],
                                     1.0 / exposing_->tracers.samples};
            integrate_instants(lists.of(i), sampled, [&](const SurfaceSegment& s, std::size_t e, double t) {
                deposit(e, &s, t, share_of(sampled[e], exposures_[e]));
            });
        }
    }

    static double share_of(TimeRange part, TimeRange exposure) {
        return exposure.duration_s() > 0.0 ? part.duration_s() / exposure.duration_s() : 1.0;
    }

    // Adds what one sample sees at a time to its pixel.
    struct Deposit {
        const TileExposure* tile;
        const ImageSample* sample;
        std::span<const SurfaceSegment> reflected;
        std::uint32_t pixel;
        double weight;  // of the sample in its pixel

        void operator()(std::size_t exposure, const SurfaceSegment* seen, double time_s, double share) const {
            const SceneShader::Sighting sighting = {sample->x, sample->y, seen, reflected};
            tile->films_[exposure]->add(pixel, static_cast<float>(share * weight),
                                        tile->exposing_->shader.radiance(*tile->piece_, sighting, time_s));
        }
    };

    const Exposing* exposing_;
    const MotionPiece* piece_;
    std::span<const TimeRange> exposures_;
    std::span<FilmFrame* const> films_;
    std::vector<TimeRange> planned_;
    PreparedSight prepared_lines_, prepared_samples_;
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
