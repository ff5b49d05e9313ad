#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "flight/motion.h"
#include "shot/expose_piece.h"
#include "shot/line_pattern.h"

namespace overfly {

// A stretch of the picture, rows and columns alike, in which all lines drift the same way.
inline constexpr int kDriftTileSide_px = 64;

// Whether one sweep does for all exposures of a piece: they are equally long, and not so short that lines would pass
// all of the picture in between.
[[nodiscard]] bool are_swept_together(const Exposing& exposing, const MotionPiece& piece);

struct DriftView;

// The light of lines that drift over the picture, for the frames of one piece of the camera's motion. They drift across
// the motion of what they see, or nearly: along x or y, whichever is more across it, tile by tile (design 3.5). A frame
// without exposure time is swept in the same way while the world stands still.
//
// Where all exposures of the piece are swept together, lines drift at one speed all through the piece; else each
// exposure is swept by itself.
class DriftExposure {
  public:
    // All must outlive it. REQUIRES: a pair with drift and without discrete tracer; planned frames; of
    // exposures that aren't swept together, one.
    DriftExposure(const Exposing& exposing, const MotionPiece& piece, std::span<const TimeRange> exposures,
                  std::span<FilmFrame* const> films);
    ~DriftExposure();

    // One tile for one of the exposures, for each of both.
    struct Part {
        std::size_t tile, exposure;
    };
    [[nodiscard]] std::vector<Part> parts() const;
    // Different parts may be run from different threads at once.
    void run(const Part& part, TraceCounters& counters) const;

  private:
    void prepare(const Sight& sight, TimeRange over, double exposure_s);
    [[nodiscard]] DriftAxis axis_for(const PixelTile& tile, const MotionPiece& piece) const;

    const Exposing* exposing_;
    std::vector<TimeRange> exposures_;  // an instant stretched for the sweep
    ShutterCurve curve_;
    std::span<FilmFrame* const> films_;
    std::vector<PixelTile> tiles_;
    std::vector<DriftAxis> axes_;                      // of each tile
    std::array<std::unique_ptr<DriftView>, 2> views_;  // by axis, as far as any tile needs them
};

}  // namespace overfly
