#include "shot/drift_exposure.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "shot/drift_tile.h"
#include "shot/drifting_sight.h"

namespace overfly {
namespace {

// Something far enough to stand for the sky.
constexpr double kFar_m = 1e6;

// A stretched instant.
constexpr double kSweep_s = 1.0;

// Exposures as long as each other, but for rounding.
constexpr double kAsLong = 1e-9;

// What lines may drift in a piece. Farther, the drift is no longer the motion that it is taken for (film_drift.h), and
// most of what is prepared for the piece is never passed.
constexpr double kFarthest_px = 320.0;

// The first of all planned exposures that are in the piece, whichever are asked for.
double planned_exposure_s(const Exposing& exposing, const MotionPiece& piece) {
    const auto planned =
        std::ranges::find_if(exposing.planned, [&](const PlannedFrame& f) { return is_exposed_in(f, piece); });
    check(planned != exposing.planned.end(), "what is exposed was planned");
    return planned->exposure.duration_s();
}

}  // namespace

bool are_swept_together(const Exposing& exposing, const MotionPiece& piece) {
    const double exposure_s = planned_exposure_s(exposing, piece);
    if (exposure_s == 0.0) return false;
    if (exposing.tracers.drift_px * piece.when.duration_s() > kFarthest_px * exposure_s) return false;
    return std::ranges::all_of(exposing.planned, [&](const PlannedFrame& f) {
        return !is_exposed_in(f, piece) || std::abs(f.exposure.duration_s() - exposure_s) <= kAsLong * exposure_s;
    });
}

DriftExposure::DriftExposure(const Exposing& exposing, const MotionPiece& piece, std::span<const TimeRange> exposures,
                             std::span<FilmFrame* const> films)
    : exposing_(&exposing),
      exposures_(exposures.begin(), exposures.end()),
      films_(films),
      tiles_(tiles_of(exposing.size, kDriftTileSide_px)) {
    for (const PixelTile& tile : tiles_) axes_.push_back(axis_for(tile, piece));
    const Sight& seen = exposing.tracers.continuous->sight();
    if (are_swept_together(exposing, piece)) {
        curve_ = exposing.curve;
        prepare(seen, piece.when, planned_exposure_s(exposing, piece));
        return;
    }
    TimeRange& exposure = exposures_.front();
    if (exposure.duration_s() == 0.0) {
        const double time_s = exposure.begin_s;
        exposure = {time_s - 0.5 * kSweep_s, time_s + 0.5 * kSweep_s};
        prepare(standing_still(seen, time_s, exposure), exposure, kSweep_s);
        return;
    }
    curve_ = exposing.curve;
    const TimeRange open = intersection(exposure, piece.when);
    if (open.duration_s() > kLeastShare * exposure.duration_s())
        prepare(during(seen, open), open, exposure.duration_s());
}

void DriftExposure::prepare(const Sight& sight, TimeRange over, double exposure_s) {
    for (const DriftAxis axis : {DriftAxis::X, DriftAxis::Y}) {
        if (std::ranges::find(axes_, axis) == axes_.end()) continue;
        views_[static_cast<std::size_t>(axis)] =
            std::make_unique<DriftView>(*exposing_, sight, over, exposing_->tracers.drift_px / exposure_s, axis);
    }
}

DriftExposure::~DriftExposure() = default;

DriftAxis DriftExposure::axis_for(const PixelTile& tile, const MotionPiece& piece) const {
    const double x = exposing_->size.film_x(0.5 * (tile.left + tile.right));
    const double y = exposing_->size.film_y(0.5 * (tile.top + tile.bottom));
    constexpr double kMiddle = 0.5;
    const Vector<Scene> direction = piece.direction_at(kMiddle, x, y);
    const Point<Scene> eye = piece.origin_at(kMiddle);
    const auto hit = exposing_->tracers.ground->first_hit(eye, direction);
    const Point<Scene> seen = eye + (hit ? hit->distance : kFar_m) * direction;
    const FilmPoint begin = film_point(piece, 0.0, seen), end = film_point(piece, 1.0, seen);
    if (begin.depth_m <= 0.0 || end.depth_m <= 0.0) return DriftAxis::X;
    return std::abs(end.y - begin.y) > std::abs(end.x - begin.x) ? DriftAxis::X : DriftAxis::Y;
}

std::vector<DriftExposure::Part> DriftExposure::parts() const {
    std::vector<Part> out;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        if (views_[static_cast<std::size_t>(axes_[t])] == nullptr) continue;
        if (exposing_->wanted && !exposing_->wanted(tiles_[t].left, tiles_[t].top)) continue;
        for (std::size_t e = 0; e < exposures_.size(); ++e) out.push_back({t, e});
    }
    return out;
}

void DriftExposure::run(const Part& part, TraceCounters& counters) const {
    const DriftView& view = *views_[static_cast<std::size_t>(axes_[part.tile])];
    DriftTile(*exposing_, tiles_[part.tile], view, curve_, counters)
        .expose(exposures_[part.exposure], *films_[part.exposure]);
}

}  // namespace overfly
