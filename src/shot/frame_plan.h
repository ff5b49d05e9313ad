#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "config/documents.h"
#include "config/frame_range.h"
#include "core/time_range.h"

namespace overfly {

// One frame of a shot: its number, its time on the flight's axis, when its shutter is open, and its file.
struct PlannedFrame {
    int number = 1;
    double time_s = 0.0;
    TimeRange exposure;
    std::filesystem::path file;
    double lasts_s = 0.0;  // of the flight, to the next frame
};

// Every frame of a shot in order, numbered from frames.first; frame k after the first is at start_s + k / rate after
// the flight's first keyframe, or where the shot's speeds put it (flight/flight_clock.h). A shutter's angle is of the
// frame's time in the flight: of slow motion an exposure is as much shorter, and where speeds change each is as long as
// the flight takes for it, so that exposures of 360 degrees leave no gap. Its seconds are the flight's. Without a
// count, as many frames as begin before the flight ends (one, for a flight without duration). Throws UserError where
// the flight ends before the first frame, or an exposure lasts until the next.
[[nodiscard]] std::vector<PlannedFrame> plan_frames(const ShotDocument& shot, TimeRange flight);

// The times that any of the frames is exposed.
[[nodiscard]] TimeRange exposed_times(std::span<const PlannedFrame> frames);

// NAME.0001.exr
[[nodiscard]] std::string frame_file_name(const std::string& name, int number);

}  // namespace overfly
