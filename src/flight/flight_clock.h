#pragma once

#include <vector>

#include "flight/shutter.h"

namespace overfly {

// How fast the flight goes by at a frame: 1 is as it was flown, 0.25 slow motion. Above 0.
struct FlightSpeed {
    double frame = 0.0;  // number
    double speed = 1.0;

    friend constexpr bool operator==(const FlightSpeed&, const FlightSpeed&) = default;
};

// Which time of the flight each frame shows, and any time between two frames. Between two given speeds the speed
// changes evenly, before the first and after the last it stays; time is its integral, in closed form, so it is
// continuous and always goes on.
class FlightClock {
  public:
    // The frame numbered `first` is at start_s. REQUIRES: speeds by ascending frame; none: 1.
    FlightClock(FrameRate rate, int first, double start_s, std::vector<FlightSpeed> speeds);

    // Of a frame's number and parts of it.
    [[nodiscard]] double time_s(double frame) const;
    // Whether all frames last equally long.
    [[nodiscard]] bool is_even() const { return speeds_.size() < 2; }

  private:
    [[nodiscard]] double frames_until(double frame) const;  // of a flight at speed 1

    FrameRate rate_;
    double first_, start_s_;
    std::vector<FlightSpeed> speeds_;
    double before_first_;  // frames_until(first)
};

}  // namespace overfly
