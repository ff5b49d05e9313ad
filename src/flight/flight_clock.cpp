#include "flight/flight_clock.h"

#include <algorithm>
#include <utility>

namespace overfly {

FlightClock::FlightClock(FrameRate rate, int first, double start_s, std::vector<FlightSpeed> speeds)
    : rate_(rate), first_(first), start_s_(start_s), speeds_(std::move(speeds)), before_first_(frames_until(first_)) {}

double FlightClock::time_s(double frame) const {
    // One product and one quotient, without accumulated rounding.
    return start_s_ + (frames_until(frame) - before_first_) * rate_.denominator / rate_.numerator;
}

double FlightClock::frames_until(double frame) const {
    if (speeds_.empty()) return frame;
    const FlightSpeed& begin = speeds_.front();
    if (frame <= begin.frame || speeds_.size() == 1) return (frame - begin.frame) * begin.speed;
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < speeds_.size(); ++i) {
        const FlightSpeed &from = speeds_[i], &to = speeds_[i + 1];
        const double all = to.frame - from.frame, gone = std::min(frame - from.frame, all);
        if (gone <= 0.0) break;
        sum += gone * (from.speed + 0.5 * (to.speed - from.speed) * gone / all);
    }
    return sum + std::max(frame - speeds_.back().frame, 0.0) * speeds_.back().speed;
}

}  // namespace overfly
