#pragma once

#include "flight/film_drift.h"
#include "shot/expose_piece.h"
#include "shot/line_pattern.h"
#include "trace/sight.h"

namespace overfly {

// What is traced where lines drift along one axis: the sight as they see it, prepared for a stretch of time.
struct DriftView {
    // seen: over all of `over`. exposing must outlive it.
    DriftView(const Exposing& exposing, const Sight& seen, TimeRange over, double rate_px_per_s, DriftAxis axis);
    DriftView(const DriftView&) = delete;
    DriftView& operator=(const DriftView&) = delete;

    [[nodiscard]] TimeRange when() const { return prepared.when; }
    [[nodiscard]] const MotionPiece& camera() const { return sight.motions.front().piece_at(when().centre_s()); }

    LinePattern pattern;
    double px_per_s;
    Sight sight;
    SightTracer tracer;
    PreparedSight prepared;

  private:
    [[nodiscard]] FilmDrift drift_of(PictureSize size, TimeRange over) const;
    [[nodiscard]] FilmBounds film_bounds(TimeRange over, double drift_px, double margin_px) const;
};

}  // namespace overfly
