#include "shot/drift_view.h"

#include "shot/drifting_sight.h"

namespace overfly {

DriftView::DriftView(const Exposing& exposing, const Sight& seen, TimeRange over, double rate_px_per_s, DriftAxis axis)
    : pattern{exposing.size, axis, exposing.tracers.lines},
      px_per_s(rate_px_per_s),
      sight(drifting(seen, over, drift_of(exposing.size, over))),
      tracer(exposing.tracers.continuous->surfaces(), sight),
      prepared(tracer.prepare(over, film_bounds(over, exposing.tracers.drift_px, exposing.margin_px()))) {}

FilmDrift DriftView::drift_of(PictureSize size, TimeRange over) const {
    const double rate = px_per_s * size.film_per_px();
    if (pattern.axis == DriftAxis::X) return {rate, 0.0, over.centre_s()};
    return {0.0, rate, over.centre_s()};
}

// Where samples are in the middle of `over` that are in the picture at any time of an exposure. Their homes are up to
// half an exposure's drift outside of it, and the middle of an exposure may be half an exposure before or after `over`.
FilmBounds DriftView::film_bounds(TimeRange over, double drift_px, double margin_px) const {
    FilmBounds b = pattern.size.film_bounds(margin_px);
    const double margin = (0.5 * px_per_s * over.duration_s() + drift_px) * pattern.size.film_per_px();
    (pattern.axis == DriftAxis::X ? b.low_x : b.low_y) -= margin;
    (pattern.axis == DriftAxis::X ? b.high_x : b.high_y) += margin;
    return b;
}

}  // namespace overfly
