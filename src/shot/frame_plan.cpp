#include "shot/frame_plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"

namespace overfly {
namespace {

// A flight of 4 s has 96 frames at 24 per second, not 97 because of a rounding.
constexpr double kRounding_frames = 1e-6;

// More than anyone asks for, as of frames.count.
constexpr int kMostFrames = 10'000'000;

FlightClock clock_of(const FramesDocument& frames, TimeRange flight) {
    return {frames.rate, frames.first, flight.begin_s + frames.start_s, frames.speeds};
}

int frames_in_flight(const ShotDocument& shot, const FlightClock& clock, TimeRange flight) {
    const int first = shot.frames.first;
    if (clock.is_even()) {
        const double left_s = flight.duration_s() - shot.frames.start_s;
        const double speed = shot.frames.speeds.empty() ? 1.0 : shot.frames.speeds.front().speed;
        const double lasting = std::ceil(left_s * shot.frames.rate.per_s() / speed - kRounding_frames);
        return std::clamp(static_cast<int>(std::min<double>(lasting, kMostFrames)), 1, kMostFrames);
    }
    int count = 1;
    while (count < kMostFrames && clock.time_s(first + count + kRounding_frames) < flight.end_s) ++count;
    return count;
}

TimeRange exposure_of(const ShotDocument& shot, const FlightClock& clock, int number, double time_s) {
    const Shutter& shutter = shot.shutter;
    if (shutter.seconds || shot.frames.speeds.empty()) return shutter.open(time_s, shot.frames.rate);
    const double frames = shutter.angle.degrees() / 360.0, begin = number - shutter.part_before() * frames;
    return {clock.time_s(begin), clock.time_s(begin + frames)};
}

void check_exposures(const ShotDocument& shot, std::span<const PlannedFrame> frames) {
    if (!shot.shutter.seconds) return;
    for (const PlannedFrame& f : frames.first(frames.size() - 1)) {
        if (*shot.shutter.seconds <= f.lasts_s * (1.0 + kRounding_frames)) continue;
        throw UserError({shot.file}, fmt::format("shutter.seconds: got {}, but frame {} lasts {:.6f} s of the flight",
                                                 *shot.shutter.seconds, f.number, f.lasts_s));
    }
}

}  // namespace

std::vector<PlannedFrame> plan_frames(const ShotDocument& shot, TimeRange flight) {
    if (flight.duration_s() < shot.frames.start_s && !shot.frames.count) {
        throw UserError({shot.file},
                        fmt::format("frames.start_s: got {}, but the flight lasts {:.3f} s; no frame is left",
                                    shot.frames.start_s, flight.duration_s()));
    }
    const FlightClock clock = clock_of(shot.frames, flight);
    const int count = shot.frames.count.value_or(frames_in_flight(shot, clock, flight));
    std::vector<PlannedFrame> frames;
    for (int k = 0; k < count; ++k) {
        const int number = shot.frames.first + k;
        const double time_s = clock.time_s(number);
        frames.push_back({number, time_s, exposure_of(shot, clock, number, time_s),
                          shot.output.folder / frame_file_name(shot.output.name, number),
                          clock.time_s(number + 1) - time_s});
    }
    check_exposures(shot, frames);
    return frames;
}

TimeRange exposed_times(std::span<const PlannedFrame> frames) {
    TimeRange all = frames.front().exposure;
    for (const PlannedFrame& f : frames) {
        all = {std::min(all.begin_s, f.exposure.begin_s), std::max(all.end_s, f.exposure.end_s)};
    }
    return all;
}

std::string frame_file_name(const std::string& name, int number) { return fmt::format("{}.{:04}.exr", name, number); }

}  // namespace overfly
