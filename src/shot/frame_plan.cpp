#include "shot/frame_plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"

namespace overfly {
namespace {

// A flight of 4 s has 96 frames at 24 per second, not 97 because of a rounding.
constexpr double kRounding_frames = 1e-6;

}  // namespace

std::vector<PlannedFrame> plan_frames(const ShotDocument& shot, TimeRange flight) {
    const FrameRate rate = shot.frames.rate;
    const double left_s = flight.duration_s() - shot.frames.start_s;
    if (left_s < 0.0 && !shot.frames.count) {
        throw UserError({shot.file},
                        fmt::format("frames.start_s: got {}, but the flight lasts {:.3f} s; no frame is left",
                                    shot.frames.start_s, flight.duration_s()));
    }
    const double lasting = std::ceil(left_s * rate.per_s() - kRounding_frames);
    const int count = shot.frames.count.value_or(std::max(1, static_cast<int>(lasting)));
    std::vector<PlannedFrame> frames;
    for (int k = 0; k < count; ++k) {
        const int number = shot.frames.first + k;
        const double time_s = flight.begin_s + shot.frames.start_s + rate.time_s(k);
        frames.push_back({number, time_s, shot.shutter.open(time_s, rate),
                          shot.output.folder / frame_file_name(shot.output.name, number)});
    }
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
