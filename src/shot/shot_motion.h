#pragma once

#include <span>

#include "config/documents.h"
#include "flight/motion.h"
#include "shot/frame_plan.h"
#include "shot/stage.h"

namespace overfly {

// How exactly a shot's motions are fitted.
[[nodiscard]] MotionOptions motion_options(const ShotDocument& shot);

// The inverted flight over all exposures of a shot's frames. The same for every choice of frames.
[[nodiscard]] Motion shot_motion(const ShotDocument& shot, const CameraPath& path, std::span<const PlannedFrame> frames,
                                 const Stage& stage);

}  // namespace overfly
