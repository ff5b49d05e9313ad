#pragma once

#include <cstdint>
#include <optional>

#include "config/documents.h"
#include "shot/surfaces.h"
#include "shot/tile_choice.h"

namespace overfly {

// The tracers that a shot asks for, what they trace, and the filter of its pixels.
class ShotTracers {
  public:
    // All must outlive it. check_every: RenderOptions.
    ShotTracers(const ShotDocument& shot, const Stage& stage, const ShotBodies& bodies, const Sight& sight,
                std::uint64_t check_every = 0);
    ShotTracers(const ShotTracers&) = delete;
    ShotTracers& operator=(const ShotTracers&) = delete;

    [[nodiscard]] TracerPair pair() const;
    [[nodiscard]] const PixelFilter* filter() const { return filter_ ? &*filter_ : nullptr; }  // Exposing's

  private:
    struct Part {
        Surfaces surfaces;
        SightTracer tracer;
        Part(std::optional<SunShadows> shadows, const Stage& stage, const ShotBodies& bodies, TracerKind kind,
             const Sight& sight, std::optional<TraceCheck> check)
            : surfaces(shadows, stage, bodies, kind, check), tracer(surfaces.all(), sight) {}
    };

    std::optional<Part> continuous_, discrete_;
    int lines_, samples_;
    double drift_px_, error_;
    const RayScene* ground_;
    std::optional<PixelFilter> filter_;
};

}  // namespace overfly
