#include "shot/surfaces.h"

namespace overfly {

Surfaces::Surfaces(std::optional<SunShadows> shadows, const Stage& stage, const ShotBodies& bodies, TracerKind kind) {
    add(stage.rays(), kind);
    surfaces_.front().shades_itself = shadows == SunShadows::Exact;
    if (shadows && (shadows == SunShadows::Exact || !bodies.empty())) let_block(stage.rays(), 0);
    for (const auto& body : bodies) {
        add(body->rays(), kind);
        Surface& surface = surfaces_.back();
        surface.is_mirror = body->is_mirror();
        surface.mirror = body->plane();
        surface.shades_itself = true;
        if (shadows && body->document().shadow) let_block(body->rays(), surfaces_.size() - 1);
    }
}

void Surfaces::add(const RayScene& rays, TracerKind kind) {
    if (kind == TracerKind::Discrete) {
        tracers_.emplace_back(DiscreteTracer(rays));
    } else {
        tracers_.emplace_back(IntervalTracer(rays.mesh()));
    }
    surfaces_.push_back({&rays.mesh(), &tracers_.back()});
}

void Surfaces::let_block(const RayScene& rays, std::size_t surface) {
    if (const auto* interval = std::get_if<IntervalTracer>(&tracers_[surface])) {
        blockers_.emplace_back(ShadowTracer(rays.mesh(), interval->hierarchy()));
    } else {
        blockers_.emplace_back(DiscreteShadowTracer(rays));
    }
    surfaces_[surface].blocker = &blockers_.back();
}

}  // namespace overfly
