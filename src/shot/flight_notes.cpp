#include "shot/flight_notes.h"

#include <algorithm>

#include <fmt/format.h>

namespace overfly {
namespace {

// Of 0.1 s times a rate of 10 and the like.
constexpr double kRounding_s = 1e-9;

}  // namespace

std::vector<std::string> flight_notes(std::span<const PlannedFrame> frames, const CameraPath& path,
                                      const Surroundings& surroundings) {
    const auto is_below_ground = [&](const PlannedFrame& f) {
        const Geodetic place = path.place_at(f.time_s);
        const auto ground_m = surroundings.ground_height_m(place.lon, place.lat);
        return ground_m && place.height_m < *ground_m;
    };
    const TimeRange flight = path.times();
    const auto is_outside = [&](const PlannedFrame& f) {
        return f.time_s < flight.begin_s - kRounding_s || f.time_s > flight.end_s + kRounding_s;
    };
    std::vector<std::string> notes;
    const auto note = [&](const auto& holds, const std::string& what) {
        const auto first = std::ranges::find_if(frames, holds);
        if (first == frames.end()) return;
        notes.push_back(fmt::format("note: in {} of {} frames, the first is {}, {}",
                                    std::ranges::count_if(frames, holds), frames.size(), first->number, what));
    };
    note(is_below_ground, "the camera is below the ground");
    note(is_outside, fmt::format("the flight of {:.3f} s has not begun or is over, and the camera goes straight on",
                                 flight.duration_s()));
    return notes;
}

}  // namespace overfly
