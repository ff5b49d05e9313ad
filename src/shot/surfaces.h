#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "shot/shot_body.h"
#include "shot/stage.h"
#include "trace/sight.h"

namespace overfly {

// The terrain and the bodies of a shot, each with a tracer of its own.
class Surfaces {
  public:
    // Stage and bodies must outlive it. Nothing throws a shadow where there is no sun (no `shadows`), and terrain none
    // on itself where those are in its light already. check: of the kinetic
    // tracer. REQUIRES: kind is not Hybrid, which is a pair of these.
    Surfaces(std::optional<SunShadows> shadows, const Stage& stage, const ShotBodies& bodies, TracerKind kind,
             std::optional<TraceCheck> check = std::nullopt);
    Surfaces(const Surfaces&) = delete;
    Surfaces& operator=(const Surfaces&) = delete;

    // Surface 0 is the terrain, k + 1 is body k.
    [[nodiscard]] std::span<const Surface> all() const { return surfaces_; }

  private:
    void add(const RayScene& rays, std::optional<TracerKind> kind);
    void let_block(const RayScene& rays, std::size_t surface);

    std::optional<KineticTracer> kinetic_;
    std::deque<Tracer> tracers_;  // surfaces point to them
    std::deque<SunBlocker> blockers_;
    std::vector<Surface> surfaces_;
};

}  // namespace overfly
