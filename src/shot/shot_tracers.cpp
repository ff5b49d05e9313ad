#include "shot/shot_tracers.h"

namespace overfly {

ShotTracers::ShotTracers(const ShotDocument& shot, const Stage& stage, const ShotBodies& bodies, const Sight& sight,
                         std::uint64_t check_every)

    : lines_(shot.sampling.lines),
      samples_(shot.sampling.samples),
      drift_px_(shot.sampling.drift_px),
      error_(shot.sampling.error),
      ground_(&stage.rays()) {
    const ImageDocument& image = shot.image;
    const double width_px = image.filter_width_px.value_or(usual_width_px(image.filter));
    if (image.filter != FilterKind::Box || width_px != 1.0) filter_.emplace(image.filter, width_px);
    const TracerKind kind = shot.sampling.tracer;
    std::optional<SunShadows> shadows;
    if (shot.look.look.sun_elevation.radians() > 0.0) shadows = shot.look.sun_shadows;
    std::optional<TraceCheck> check;
    if (check_every > 0) check.emplace(stage.rays(), check_every, shot.image.width);
    const auto make = [&](std::optional<Part>& part, TracerKind one) {
        part.emplace(shadows, stage, bodies, one, sight, check);
    };
    const bool is_hybrid = kind == TracerKind::Hybrid;
    if (kind != TracerKind::Discrete) make(continuous_, is_hybrid ? TracerKind::Interval : kind);
    if (kind == TracerKind::Discrete || is_hybrid) make(discrete_, TracerKind::Discrete);
}

TracerPair ShotTracers::pair() const {
    return {continuous_ ? &continuous_->tracer : nullptr,
            lines_,
            discrete_ ? &discrete_->tracer : nullptr,
            samples_,
            discrete_ ? 0.0 : drift_px_,
            error_,
            ground_};
}

}  // namespace overfly
