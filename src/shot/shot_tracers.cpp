#include "shot/shot_tracers.h"

namespace overfly {

ShotTracers::ShotTracers(const ShotDocument& shot, const Stage& stage, const ShotBodies& bodies, const Sight& sight)
    : lines_(shot.sampling.lines), samples_(shot.sampling.samples) {
    const TracerKind kind = shot.sampling.tracer;
    std::optional<SunShadows> shadows;
    if (shot.look.look.sun_elevation.radians() > 0.0) shadows = shot.look.sun_shadows;
    const auto make = [&](TracerKind one) { return Surfaces(shadows, stage, bodies, one); };
    if (kind != TracerKind::Discrete) continuous_.emplace(make(TracerKind::Interval), sight);
    if (kind != TracerKind::Interval) discrete_.emplace(make(TracerKind::Discrete), sight);
}

TracerPair ShotTracers::pair() const {
    return {continuous_ ? &continuous_->tracer : nullptr, lines_, discrete_ ? &discrete_->tracer : nullptr, samples_};
}

}  // namespace overfly
