#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "flight/body_motion.h"
#include "geo/scene_frame.h"

namespace overfly {

// A body's place and attitude in the scene, as functions of time.
// GUARANTEES: poses are rigid. Outside the time range of a flight that it follows it goes on in a straight line, as a
// camera does (camera_path.h).
class BodyPath {
  public:
    // REQUIRES: check_body_motion finds nothing.
    BodyPath(const BodyMotion& motion, const SceneFrame& frame, const Surroundings& surroundings);

    [[nodiscard]] Transform<Scene, Body> pose_at(double time_s) const { return pose_at_(time_s); }
    // Times, ascending, between which the pose is one analytic function. None where it is one for all times.
    [[nodiscard]] const std::vector<double>& joints_s() const { return joints_s_; }
    // The pose is the same at all times.
    [[nodiscard]] bool stands_still() const { return stands_still_; }

  private:
    std::function<Transform<Scene, Body>(double time_s)> pose_at_;
    std::vector<double> joints_s_;
    bool stands_still_ = false;
};

// Where a body, and the keyframes that it follows, stand in their documents.
struct BodyPlaces {
    Place body;
    std::vector<Place> keyframes;
};

// Everything that keeps a body called `name` from moving like this over these surroundings: numbers that are not
// finite, a height above ground where there is no ground; for keyframes what check_keyframes finds.
[[nodiscard]] std::vector<Problem> check_body_motion(const std::string& name, const BodyMotion& motion,
                                                     const BodyPlaces& places, const Surroundings& surroundings);

}  // namespace overfly
