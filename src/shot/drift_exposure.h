#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "flight/motion.h"
#include "shot/drift_fields.h"
#include "shot/expose_piece.h"

namespace overfly {

struct DriftView;

// The light of lines that drift over the picture, for the frames of one piece of the camera's motion: along x or y,
// tile by tile (drift_axis.h). A frame without exposure time is swept in the same way while the world stands still.
//
// Where all exposures of the piece are equally long, lines drift at one speed all through stretches of it
// (drift_stretches.h); else each exposure is swept by itself.
class DriftExposure {
  public:
    // Both must outlive it. REQUIRES: a pair with drift and without discrete tracer; planned frames.
    DriftExposure(const Exposing& exposing, const MotionPiece& piece);
    ~DriftExposure();
    DriftExposure(const DriftExposure&) = delete;
    DriftExposure& operator=(const DriftExposure&) = delete;

    // For the first of these exposures and all that one sweep does for as well: says how many they are. What has been
    // prepared for exposures of the same sweep is used again. films: of the exposures; must outlive the parts.
    [[nodiscard]] std::size_t prepare(std::span<const TimeRange> exposures, std::span<FilmFrame* const> films);

    // One field for one of the exposures, for each of both.
    struct Part {
        std::size_t field, exposure;
    };
    [[nodiscard]] std::vector<Part> parts() const;
    // Different parts may be run from different threads at once.
    void run(const Part& part, TraceCounters& counters) const;

  private:
    void prepare_alone(TimeRange exposure);
    void look(const Sight& sight, TimeRange over, double exposure_s);
    [[nodiscard]] std::size_t stretch_of(TimeRange exposure) const;

    const Exposing* exposing_;
    const MotionPiece* piece_;
    std::vector<TimeRange> planned_;
    std::vector<TimeRange> stretches_;
    std::size_t stretch_;  // that views_ are of; none: stretches_.size()
    std::vector<DriftField> fields_;
    std::array<std::unique_ptr<DriftView>, 2> views_;  // by axis, as far as any field needs them
    std::vector<TimeRange> exposures_;                 // an instant stretched for the sweep
    std::span<FilmFrame* const> films_;
    ShutterCurve curve_;
};

}  // namespace overfly
