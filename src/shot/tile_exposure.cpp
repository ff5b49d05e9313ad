#include "shot/tile_exposure.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "film/integrate.h"
#include "shot/line_deposits.h"
#include "shot/run_shares.h"

namespace overfly {
namespace {

// A phase is below 1.
constexpr double kLastPhase = 0x1.fffffffffffffp-1;

// Exposures in a row that lines are followed through before they set out anew. The more, the less setting out costs at
// a high frame rate; the fewer, the less is followed in vain where memory allows for a few frames at once only.
constexpr std::size_t kLongestWalk = 128;

SceneShader::Sighting sighting(const TileSamples& lines, std::size_t i, const SurfaceSegment* seen,
                               const SurfaceSegmentLists& lists) {
    return {lines.samples[i].x, lines.samples[i].y, seen, lists.reflected};
}

double weight_of(const TileSamples& tiled, std::size_t i) { return tiled.weights.empty() ? 1.0 : tiled.weights[i]; }

}  // namespace

TilePreparation::TilePreparation(const Exposing& exposed, const MotionPiece& of) : exposing(&exposed), piece(&of) {
    const TracerPair& tracers = exposing->tracers;
    const FilmBounds picture = exposing->size.film_bounds(exposing->margin_px());
    if (tracers.continuous != nullptr) lines = tracers.continuous->prepare(piece->when, picture);
    if (tracers.discrete != nullptr) samples = tracers.discrete->prepare(piece->when, picture);
    planned = planned_exposures(*exposing, *piece);
    is_kinetic = tracers.continuous != nullptr && tracers.continuous->surfaces().front().kinetic != nullptr;
}

std::vector<Walk> walks_through(std::span<const TimeRange> planned, std::span<const TimeRange> exposures) {
    // The planned exposure that one is; benches ask for parts of them.
    const auto number = [&](TimeRange exposure) {
        const auto after = std::ranges::upper_bound(planned, exposure.centre_s(), {}, &TimeRange::begin_s);
        return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - planned.begin(), 1) - 1);
    };
    std::vector<Walk> out;
    std::optional<std::size_t> walk;
    for (std::size_t e = 0; e < exposures.size(); ++e) {
        if (const std::size_t of = number(exposures[e]) / kLongestWalk; of != walk) {
            walk = of;
            const TimeRange begin = planned[of * kLongestWalk];
            out.push_back({e, 0, {}});
            if (begin != exposures[e]) out.back().traced.push_back(begin);
        }
        ++out.back().count;
        out.back().traced.push_back(exposures[e]);
    }
    return out;
}

TileExposure::TileExposure(const TilePreparation& prepared, std::span<const TimeRange> exposures,
                           std::span<FilmFrame* const> films, std::vector<TimeRange> traced)
    : prepared_(&prepared),
      exposing_(prepared.exposing),
      piece_(prepared.piece),
      exposures_(exposures),
      films_(films),
      traced_(std::move(traced)) {}

void TileExposure::run(const PixelTile& tile, TraceCounters& counters) const {
    const TracerPair& tracers = exposing_->tracers;
    if (tracers.continuous == nullptr) return sample(tile, exposures_, counters);
    const TileSamples lines = samples_of(tile, exposing_->size, tracers.lines, exposing_->filter);
    if (tracers.discrete == nullptr ||
        lines_are_cheaper(tracers, prepared_->lines, lines.samples, prepared_->planned, counters)) {
        return follow(lines, counters);
    }
    // The exposures' parts in this piece, each of which counts for its share: the rest may be followed.
    std::vector<TimeRange> parts;
    for (const TimeRange& e : exposures_) parts.push_back(intersection(e, piece_->when));
    sample(tile, parts, counters);
}

void TileExposure::follow(const TileSamples& lines, TraceCounters& counters) const {
    SurfaceSegmentLists lists;
    exposing_->tracers.continuous->trace(prepared_->lines, lines.samples, traced_, lists, counters);
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

void TileExposure::follow_ground(const TileSamples& lines, const SurfaceSegmentLists& lists) const {
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
void TileExposure::for_each_exposure_of(const TileSamples& lines, const WithExposure& with_exposure) const {
    for (std::size_t i = 0; i < lines.samples.size(); ++i) {
        for (std::uint32_t e = 0; e < exposures_.size(); ++e) with_exposure(i, e);
    }
}

// sampled: the exposures, or parts of them.
void TileExposure::sample(const PixelTile& tile, std::span<const TimeRange> sampled, TraceCounters& counters) const {
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
double TileExposure::phase_by_light(double phase, TimeRange part, TimeRange of) const {
    if (part.duration_s() == 0.0) return phase;
    const Exposure exposure = exposing_->exposure(of);
    const double until = exposure.share_until(part.begin_s) + phase * exposure.share_of(part);
    return std::clamp((exposure.time_at(until) - part.begin_s) / part.duration_s(), 0.0, kLastPhase);
}

// sampled: of the exposures from `first` on.
void TileExposure::sample(const TileSamples& tiled, std::span<const TimeRange> sampled, std::size_t first,
                          TraceCounters& counters) const {
    SurfaceSegmentLists lists;
    exposing_->tracers.discrete->trace(prepared_->samples, tiled.samples, sampled, lists, counters);
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

double TileExposure::share_of(TimeRange part, TimeRange exposure) const {
    return exposure.duration_s() > 0.0 ? exposing_->exposure(exposure).share_of(part) : 1.0;
}

}  // namespace overfly
