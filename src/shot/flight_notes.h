#pragma once

#include <span>
#include <string>
#include <vector>

#include "flight/camera_path.h"
#include "shot/frame_plan.h"

namespace overfly {

// What can be rendered but is seldom meant, a line each: frames in which the camera is below the ground, frames before
// the flight's first keyframe or after its last.
[[nodiscard]] std::vector<std::string> flight_notes(std::span<const PlannedFrame> frames, const CameraPath& path,
                                                    const Surroundings& surroundings);

}  // namespace overfly
