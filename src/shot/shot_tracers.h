#pragma once

#include <optional>

#include "config/documents.h"
#include "shot/surfaces.h"
#include "shot/tile_choice.h"

namespace overfly {

// The tracers that a shot asks for, and what they trace.
class ShotTracers {
  public:
    // All must outlive it.
    ShotTracers(const ShotDocument& shot, const Stage& stage, const ShotBodies& bodies, const Sight& sight);
    ShotTracers(const ShotTracers&) = delete;
    ShotTracers& operator=(const ShotTracers&) = delete;

    [[nodiscard]] TracerPair pair() const;

  private:
    struct Part {
        Surfaces surfaces;
        SightTracer tracer;
        Part(Surfaces made, const Sight& sight) : surfaces(std::move(made)), tracer(surfaces.all(), sight) {}
    };

    std::optional<Part> continuous_, discrete_;
    int lines_, samples_;
};

}  // namespace overfly
