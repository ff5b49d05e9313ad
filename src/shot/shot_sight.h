#pragma once

#include "config/documents.h"
#include "flight/camera_path.h"
#include "shot/shot_body.h"
#include "shot/stage.h"
#include "trace/sight.h"

namespace overfly {

// What a sight is made from.
struct SightSubjects {
    const Stage& stage;        // surface 0
    const ShotBodies& bodies;  // surfaces from 1 on
    Vector<Scene> to_sun;
};

// How the terrain and every body move relative to the camera, and relative to the camera in the mirrors that it may be
// seen in, one behind another as often as the shot says. The camera's own motion over the terrain is that of
// shot_motion; all others are cut where it is, and wherever else the bound asks for it.
[[nodiscard]] Sight make_sight(const ShotDocument& shot, const CameraPath& path, Motion camera,
                               const SightSubjects& subjects);

// The largest error of any motion in it, in pixels.
[[nodiscard]] double largest_error_px(const Sight& sight);

}  // namespace overfly
