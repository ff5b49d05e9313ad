#include "shot/drift_exposure.h"

#include <algorithm>
#include <cmath>

#include "shot/drift_stretches.h"
#include "shot/drift_tile.h"
#include "shot/drifting_sight.h"

namespace overfly {
namespace {

// A stretched instant.
constexpr double kSweep_s = 1.0;

}  // namespace

DriftExposure::DriftExposure(const Exposing& exposing, const MotionPiece& piece)
    : exposing_(&exposing),
      piece_(&piece),
      planned_(planned_exposures(exposing, piece)),
      stretches_(drift_stretches(piece.when, planned_, exposing.tracers.drift_px)),
      stretch_(stretches_.size()),
      fields_(drift_fields(exposing, piece)) {}

DriftExposure::~DriftExposure() = default;

std::size_t DriftExposure::prepare(std::span<const TimeRange> exposures, std::span<FilmFrame* const> films) {
    films_ = films;
    if (stretches_.empty()) {
        prepare_alone(exposures.front());
        return 1;
    }
    const std::size_t stretch = stretch_of(exposures.front());
    const auto last = std::ranges::find_if(exposures, [&](TimeRange e) { return stretch_of(e) != stretch; });
    exposures_.assign(exposures.begin(), last);
    if (stretch == stretch_) return exposures_.size();
    const Sight& seen = exposing_->tracers.continuous->sight();
    const TimeRange over = stretches_[stretch];
    const double exposure_s = planned_.front().duration_s();
    curve_ = exposing_->curve;
    views_ = {};
    if (stretches_.size() == 1) {
        look(seen, over, exposure_s);
    } else {
        look(during(seen, over), over, exposure_s);
    }
    stretch_ = stretch;
    return exposures_.size();
}

void DriftExposure::prepare_alone(TimeRange exposure) {
    const Sight& seen = exposing_->tracers.continuous->sight();
    views_ = {};
    curve_ = {};
    if (exposure.duration_s() == 0.0) {
        const double time_s = exposure.begin_s;
        exposure = {time_s - 0.5 * kSweep_s, time_s + 0.5 * kSweep_s};
        look(standing_still(seen, time_s, exposure), exposure, kSweep_s);
    } else {
        curve_ = exposing_->curve;
        const TimeRange open = intersection(exposure, piece_->when);
        if (open.duration_s() > kLeastShare * exposure.duration_s())
            look(during(seen, open), open, exposure.duration_s());
    }
    exposures_ = {exposure};
}

// The one that has its middle, as far as it is in the piece: none is cut but by rounding.
std::size_t DriftExposure::stretch_of(TimeRange exposure) const {
    const double middle_s = intersection(exposure, piece_->when).centre_s();
    const auto after = std::ranges::upper_bound(stretches_, middle_s, {}, &TimeRange::begin_s);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - stretches_.begin(), 1) - 1);
}

void DriftExposure::look(const Sight& sight, TimeRange over, double exposure_s) {
    for (const DriftAxis axis : {DriftAxis::X, DriftAxis::Y}) {
        if (std::ranges::find(fields_, axis, &DriftField::axis) == fields_.end()) continue;
        views_[static_cast<std::size_t>(axis)] =
            std::make_unique<DriftView>(*exposing_, sight, over, exposing_->tracers.drift_px / exposure_s, axis);
    }
}

std::vector<DriftExposure::Part> DriftExposure::parts() const {
    std::vector<Part> out;
    for (std::size_t f = 0; f < fields_.size(); ++f) {
        if (views_[static_cast<std::size_t>(fields_[f].axis)] == nullptr) continue;
        for (std::size_t e = 0; e < exposures_.size(); ++e) out.push_back({f, e});
    }
    return out;
}

void DriftExposure::run(const Part& part, TraceCounters& counters) const {
    const DriftField& field = fields_[part.field];
    const DriftView& view = *views_[static_cast<std::size_t>(field.axis)];
    DriftTile(*exposing_, field.pixels, view, curve_, counters)
        .expose(exposures_[part.exposure], *films_[part.exposure]);
}

}  // namespace overfly
