#pragma once

#include <cmath>
#include <utility>

#include "shot/pixel_tile.h"
#include "trace/sight.h"
#include "two_ways/terrain_flights.h"

namespace overfly::testing {

// The camera's sight of terrain alone.
inline Sight sight_of(Motion motion) {
    Sight sight;
    sight.motions.push_back(std::move(motion));
    return sight;
}

// A flight over the terrain that ships, and the stage for it.
class SampleFlight {
  public:
    explicit SampleFlight(const ShareFlight& flight)
        : SampleFlight(flight, prepared(OVERFLY_SOURCE_DIR "/terrain/blanca_peak_utm13n_75m.tif")) {}

    [[nodiscard]] Sight sight(PictureSize size, double longest_piece_s = 1.0 / 6.0) const {
        return sight_of(motion_over(document, stage, {0.01, size.width, size.height, longest_piece_s}));
    }
    // Through a longer lens, for a small picture that is the middle of a large one: as much ground and blur in a pixel.
    [[nodiscard]] Sight sight_of_middle(PictureSize size, double share_of_width) const {
        FlightDocument middle = document;
        for (Keyframe& k : middle.keyframes)
            k.lens.horizontal_fov = Angle::radians(2.0 * std::atan(share_of_width * k.lens.tan_half_fov()));
        return sight_of(motion_over(middle, stage, {0.01, size.width, size.height}));
    }

    FlightDocument document;
    Stage stage;

  private:
    SampleFlight(const ShareFlight& flight, PreparedTerrain terrain)
        : document(flight_over(terrain.scene.report, flight)), stage(std::move(terrain), middle_of(document)) {}
};

// The exposure of a frame at 24 per second with a shutter of 180 degrees.
constexpr TimeRange half_a_frame(double begin_s) { return {begin_s, begin_s + 1.0 / 48.0}; }

}  // namespace overfly::testing
