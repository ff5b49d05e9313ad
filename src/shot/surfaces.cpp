#include "shot/surfaces.h"

#include <algorithm>

namespace overfly {

Surfaces::Surfaces(std::optional<SunShadows> shadows, const Stage& stage, const ShotBodies& bodies, TracerKind kind,
                   std::optional<TraceCheck> check) {
    const bool terrain_blocks = shadows && (shadows == SunShadows::Exact || !bodies.empty());
    const bool is_mirrored = std::ranges::any_of(bodies, [](const auto& body) { return body->is_mirror(); });
    if (kind == TracerKind::Kinetic) {
        kinetic_.emplace(stage.rays(), check);
        // For what the kinetic tracer doesn't do.
        const bool is_needed = terrain_blocks || is_mirrored;
        add(stage.rays(), is_needed ? std::optional(TracerKind::Interval) : std::nullopt);
        surfaces_.front().kinetic = &*kinetic_;
        kind = TracerKind::Interval;
    } else {
        add(stage.rays(), kind);
    }
    surfaces_.front().shades_itself = shadows == SunShadows::Exact;
    if (terrain_blocks) let_block(stage.rays(), 0);
    for (const auto& body : bodies) {
        add(body->rays(), kind);
        Surface& surface = surfaces_.back();
        surface.is_mirror = body->is_mirror();
        surface.mirror = body->plane();
        surface.shades_itself = true;
        if (shadows && body->document().shadow) let_block(body->rays(), surfaces_.size() - 1);
    }
}

void Surfaces::add(const RayScene& rays, std::optional<TracerKind> kind) {
    surfaces_.push_back({&rays.mesh()});
    if (!kind) return;
    if (*kind == TracerKind::Discrete) {
        tracers_.emplace_back(DiscreteTracer(rays));
    } else {
        tracers_.emplace_back(IntervalTracer(rays.mesh()));
    }
    surfaces_.back().tracer = &tracers_.back();
}

void Surfaces::let_block(const RayScene& rays, std::size_t surface) {
    if (const auto* interval = std::get_if<IntervalTracer>(surfaces_[surface].tracer)) {
        blockers_.emplace_back(ShadowTracer(rays.mesh(), interval->hierarchy()));
    } else {
        blockers_.emplace_back(DiscreteShadowTracer(rays));
    }
    surfaces_[surface].blocker = &blockers_.back();
}

}  // namespace overfly
