#pragma once

#include <memory>
#include <vector>

#include "core/time_range.h"
#include "flight/keyframe.h"
#include "geo/scene_frame.h"

namespace overfly {

// The camera at one time: where it is, how it is turned, and how wide it sees.
struct CameraPose {
    Point<Scene> position;
    Rotation<Scene, Camera> orientation;
    double tan_half_fov = 0.0;  // of half the horizontal field of view

    [[nodiscard]] Transform<Camera, Scene> camera_from_scene() const;
};

// The flight through its keyframes, a smooth function of time.
// GUARANTEES: passes through every keyframe at its time; position is C2, orientation and field of view are C1; between
// two keyframes height, roll and field of view stay between their two values, as does pitch between two attitudes; a
// camera that is at the same place in two neighbouring keyframes stands still between them; a span depends on the three
// keyframes before and the three after it only (two would do for C2, but then the speed between keyframes 45 degrees
// apart on a circle ripples by 10 %, not 1 %). Between two look-ats the camera aims exactly at the target, which moves
// as smoothly as the camera does. Outside its time range the flight goes on in a straight line with its last velocity,
// turning and zoom rates. (A target that is flown straight over turns the heading at once: AimCurve.)
class CameraPath {
  public:
    // REQUIRES: at least one keyframe; times strictly increasing (with one keyframe, the camera stands still);
    // surroundings answers at every keyframe and target that counts its height from the ground, and neighbouring
    // keyframes are no antipodes (check_keyframes).
    CameraPath(const std::vector<Keyframe>& keyframes, const SceneFrame& frame, const Surroundings& surroundings);

    [[nodiscard]] TimeRange times() const;
    [[nodiscard]] CameraPose pose_at(double time_s) const;
    // The same, as people speak of it. Heading in [0, 360] degrees, pitch and roll as the keyframes count them.
    [[nodiscard]] Geodetic place_at(double time_s) const;
    [[nodiscard]] Attitude attitude_at(double time_s) const;
    // The scene's frame, which the path keeps a copy of.
    [[nodiscard]] const SceneFrame& frame() const;
    // Times between which the path is one analytic function: the keyframes' own.
    [[nodiscard]] const std::vector<double>& joints_s() const;

  private:
    struct Data;
    std::shared_ptr<const Data> data_;  // immutable, so copies share it
};

}  // namespace overfly
