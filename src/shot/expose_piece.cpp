#include "shot/expose_piece.h"

#include <algorithm>
#include <mutex>

#include "core/parallel.h"
#include "film/integrate.h"
#include "shot/drift_exposure.h"
#include "shot/light_deposits.h"
#include "shot/line_deposits.h"
#include "shot/run_shares.h"

namespace overfly {
namespace {

// A phase is below 1.
constexpr double kLastPhase = 0x1.fffffffffffffp-1;

class TileExposure {
  public:
    TileExposure(const Exposing& exposing, const MotionPiece& piece, std::span<const TimeRange> exposures,
                 std::span<FilmFrame* const> films)
        : exposing_(&exposing), piece_(&piece), exposures_(exposures), films_(films) {
        const TracerPair& tracers = exposing.tracers;
        const FilmBounds picture = exposing.size.film_bounds(exposing.margin_px());
        if (tracers.continuous != nullptr) prepared_lines_ = tracers.continuous->prepare(piece.when, picture);
        if (tracers.discrete != nullptr) prepared_samples_ = tracers.discrete->prepare(piece.when, picture);
        for (const PlannedFrame& f : exposing.planned) {
            if (is_exposed_in(f, piece)) planned_.push_back(f.exposure);
        }
        traced_.assign(exposures.begin(), exposures.end());
        // Where the kinetic tracer sets out must not depend on which frames are asked for.
        const bool is_kinetic =
            tracers.continuous != nullptr && tracers.continuous->surfaces().front().kinetic != nullptr;
        if (is_kinetic && !planned_.empty() && planned_.front() != traced_.front())
            traced_.insert(traced_.begin(), planned_.front());
    }

    void run(const PixelTile& tile, TraceCounters& counters) const {
        const TracerPair& tracers = exposing_->tracers;
        if (tracers.continuous == nullptr) return sample(tile, exposures_, counters);
        const TileSamples lines = samples_of(tile, exposing_->size, tracers.lines, exposing_->filter);
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
        exposing_->tracers.continuous->trace(prepared_lines_, lines.samples, traced_, lists, counters);
        // First all that is seen of the ground, then all else, so that a pixel's light adds up in the same order
        // whichever frames are exposed.
        follow_ground(lines, lists);
        LightDeposits looks(exposing_->shader, *piece_, films_, exposing_->tracers.lines);
        for_each_exposure_of(lines, [&](std::size_t i, std::uint32_t e) {
            const double weight = weight_of(lines, i) / exposing_->tracers.lines;
            const Exposure exposure = exposing_->exposure(exposures_[e]);
            const auto look = [&](const SurfaceSegment* seen, double time_s, double share) {
                looks.add(e, lines.pixels[i], share * weight, {sighting(lines, i, seen, lists), time_s});
            };
            const auto with_stretch = [&](const SurfaceSegment* seen, TimeRange stretch, double share) {
                if (sighting(lines, i, seen, lists).is_of_ground()) return;
                for_each_look(exposure, stretch, share, [&](double t, double part) { look(seen, t, part); });
            };
            const auto at_instant = [&](const SurfaceSegment* seen, double t) { look(seen, t, 1.0); };
            integrate(lists.of(i), piece_->when, exposure, with_stretch, at_instant);
        });
    }

    void follow_ground(const TileSamples& lines, const SurfaceSegmentLists& lists) const {
        LineDeposits deposits(exposing_->shader, *piece_, films_, exposing_->tracers.lines);
        RunWeighing weighing(exposing_->curve, exposing_->filter);
        for_each_exposure_of(lines, [&](std::size_t i, std::uint32_t e) {
            const double weight = weight_of(lines, i) / exposing_->tracers.lines;
            const Exposure exposure = exposing_->exposure(exposures_[e]);
            const auto with_stretch = [&](const SurfaceSegment* seen, TimeRange stretch, double share) {
                const SceneShader::Sighting seen_so = sighting(lines, i, seen, lists);
                if (!seen_so.is_of_ground()) return;
                PixelRun to = {.film = e, .first = lines.pixels[i], .weight = share * weight};
                if (!weighing.is_even()) {
                    to.shares = &weighing.of({.from_part = exposure.part_at(stretch.begin_s),
                                              .to_part = exposure.part_at(stretch.end_s),
                                              .weight = weight,
                                              .first_pixel = to.first});
                }
                deposits.add_ground(seen_so, stretch, to);
            };
            integrate(lists.of(i), piece_->when, exposure, with_stretch, [](const SurfaceSegment*, double) {});
        });
    }

    template <class WithExposure>
    void for_each_exposure_of(const TileSamples& lines, const WithExposure& with_exposure) const {
        for (std::size_t i = 0; i < lines.samples.size(); ++i) {
            for (std::uint32_t e = 0; e < exposures_.size(); ++e) with_exposure(i, e);
        }
    }
    static SceneShader::Sighting sighting(const TileSamples& lines, std::size_t i, const SurfaceSegment* seen,
                                          const SurfaceSegmentLists& lists) {
        return {lines.samples[i].x, lines.samples[i].y, seen, lists.reflected};
    }

    static double weight_of(const TileSamples& tiled, std::size_t i) {
        return tiled.weights.empty() ? 1.0 : tiled.weights[i];
    }

    // sampled: the exposures, or parts of them.
    void sample(const PixelTile& tile, std::span<const TimeRange> sampled, TraceCounters& counters) const {
        const TileSamples tiled = samples_of(tile, exposing_->size, exposing_->tracers.samples, exposing_->filter);
        if (exposing_->curve.is_box()) return sample(tiled, sampled, 0, counters);
        for (std::size_t e = 0; e < sampled.size(); ++e) {
            if (sampled[e].duration_s() < 0.0) continue;
            TileSamples when_open = tiled;
            for (ImageSample& s : when_open.samples) s.phase = phase_by_light(s.phase, sampled[e], exposures_[e]);
            sample(when_open, sampled.subspan(e, 1), e, counters);
        }
    }

    // Where in a part of an exposure the phase's share of its light has come through.
    [[nodiscard]] double phase_by_light(double phase, TimeRange part, TimeRange of) const {
        if (part.duration_s() == 0.0) return phase;
        const Exposure exposure = exposing_->exposure(of);
        const double until = exposure.share_until(part.begin_s) + phase * exposure.share_of(part);
        return std::clamp((exposure.time_at(until) - part.begin_s) / part.duration_s(), 0.0, kLastPhase);
    }

    // sampled: of the exposures from `first` on.
    void sample(const TileSamples& tiled, std::span<const TimeRange> sampled, std::size_t first,
                TraceCounters& counters) const {
        SurfaceSegmentLists lists;
        exposing_->tracers.discrete->trace(prepared_samples_, tiled.samples, sampled, lists, counters);
        LightDeposits deposits(exposing_->shader, *piece_, films_, exposing_->tracers.samples);
        const double weight = 1.0 / exposing_->tracers.samples;
        for (std::size_t i = 0; i < tiled.samples.size(); ++i) {
            const ImageSample& sample = tiled.samples[i];
            integrate_instants(lists.of(i), sampled, [&](const SurfaceSegment& s, std::size_t e, double t) {
                deposits.add(first + e, tiled.pixels[i],
                             share_of(sampled[e], exposures_[first + e]) * weight * weight_of(tiled, i),
                             {{sample.x, sample.y, &s, lists.reflected}, t});
            });
        }
    }

    [[nodiscard]] double share_of(TimeRange part, TimeRange exposure) const {
        return exposure.duration_s() > 0.0 ? exposing_->exposure(exposure).share_of(part) : 1.0;
    }

    const Exposing* exposing_;
    const MotionPiece* piece_;
    std::span<const TimeRange> exposures_;
    std::span<FilmFrame* const> films_;
    std::vector<TimeRange> planned_;
    std::vector<TimeRange> traced_;  // the exposures that lines are followed through
    PreparedSight prepared_lines_, prepared_samples_;
};

}  // namespace

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

// Frames without exposure time are swept one by one, others all at once where they can be.
void expose_drifting(const Exposing& exposing, const MotionPiece& piece, std::span<const TimeRange> exposures,
                     std::span<FilmFrame* const> films, TraceCounters& counters, const PieceProgress& progress) {
    const std::size_t together = are_swept_together(exposing, piece) ? exposures.size() : 1;
    for (std::size_t first = 0; first < exposures.size(); first += together) {
        const DriftExposure exposure(exposing, piece, exposures.subspan(first, together),
                                     films.subspan(first, together));
        const std::vector<DriftExposure::Part> parts = exposure.parts();
        const auto run = [&](const DriftExposure::Part& part, TraceCounters& of_part) { exposure.run(part, of_part); };
        const auto some_done = [&](double share) {
            if (progress)
                progress((static_cast<double>(first) + share * static_cast<double>(together)) /
                         static_cast<double>(exposures.size()));
        };
        run_all(exposing, std::span<const DriftExposure::Part>(parts), run, counters, some_done);
    }
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

void expose_piece(const Exposing& exposing, const MotionPiece& piece, std::span<const PlannedFrame> frames,
                  std::span<FilmFrame* const> films, TraceCounters& counters, const PieceProgress& progress) {
    std::vector<TimeRange> exposures;
    for (const PlannedFrame& f : frames) exposures.push_back(f.exposure);
    if (exposing.tracers.drift_px > 0.0) return expose_drifting(exposing, piece, exposures, films, counters, progress);
    const TileExposure exposure(exposing, piece, exposures, films);
    std::vector<PixelTile> tiles = tiles_of(exposing.size);
    if (exposing.wanted)
        std::erase_if(tiles, [&](const PixelTile& tile) { return !exposing.wanted(tile.left, tile.top); });
    const auto run = [&](const PixelTile& tile, TraceCounters& of_tile) { exposure.run(tile, of_tile); };
    run_all(exposing, std::span<const PixelTile>(tiles), run, counters, progress);
}

}  // namespace overfly
