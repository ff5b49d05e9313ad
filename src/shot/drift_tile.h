#pragma once

#include <vector>

#include "shot/drift_pixels.h"
#include "shot/drift_view.h"
#include "shot/expose_piece.h"

namespace overfly {

// A part of an exposure that is no more than rounding, where it ends as a piece begins.
inline constexpr double kLeastShare = 1e-9;

// One tile of the picture while drifting lines expose it.
class DriftTile {
  public:
    // All must outlive it. curve: the shutter's while this view is exposed.
    DriftTile(const Exposing& exposing, const PixelTile& tile, const DriftView& view, const ShutterCurve& curve,
              TraceCounters& counters);

    // Adds its pixels' light of an exposure, as far as the view has it, to the picture's film.
    void expose(TimeRange exposure, FilmFrame& film);

  private:
    void sweep();
    void sweep_until_good();
    // A picture of the tile alone.
    [[nodiscard]] ExposedFrame sweep_apart(int lines, const FrameSteps& steps);
    void add(const ExposedFrame& apart, float weight, FilmFrame& film) const;
    void follow(const HomeRange& homes, TimeRange open);
    // What one of lines_ sees for a while.
    struct SkyRun {
        std::size_t line = 0;
        TimeRange when;
    };
    [[nodiscard]] SceneShader::Sighting sighting(std::size_t line, const SurfaceSegment* seen) const;

    const Exposing* exposing_;
    const DriftView* view_;
    TraceCounters* counters_;
    PixelTile tile_;
    LinePattern pattern_;
    ShutterCurve curve_;
    DriftPixels pixels_;
    FilmFrame* film_ = nullptr;  // that pixels_ are of
    std::vector<DriftingLine> lines_;
    std::vector<ImageSample> samples_;
    SurfaceSegmentLists lists_;  // of what these see
    std::vector<SkyRun> skies_;
};

}  // namespace overfly
