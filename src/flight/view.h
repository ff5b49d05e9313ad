#pragma once

#include <functional>
#include <limits>

#include "flight/ray_frame.h"

namespace overfly {

// How far from where a ray starts there may be something to see.
struct Reach {
    double nearest_m = 0.0;
    double farthest_m = std::numeric_limits<double>::infinity();
};

// Somebody who looks at something: the camera, or the camera in a mirror. All in the frame in which the thing stands
// still, its own "scene", so that for a body in motion the look moves by the camera's motion and the body's together.
struct View {
    std::function<RayFrame(double time_s)> rays_at;
    // Of the thing, from where the rays start at the time.
    std::function<Reach(double time_s, Point<Scene> origin)> reach_at;
    // Unit vector towards the sun; may be empty where nobody asks.
    std::function<Vector<Scene>(double time_s)> to_sun_at;
};

using PoseAt = std::function<Transform<Scene, Body>(double time_s)>;

// A plane that stands still in its frame: the points p of dot(normal, p - on) = 0.
struct FixedPlane {
    Point<Scene> on;
    Vector<Scene> normal;  // of unit length

    friend constexpr bool operator==(const FixedPlane&, const FixedPlane&) = default;
};

// What is at `p`, or points along `v`, in the scene, in the frame of a body in that pose, which stands still in a scene
// of its own.
[[nodiscard]] Point<Scene> seen_from(const Transform<Scene, Body>& pose, Point<Scene> p);
[[nodiscard]] Vector<Scene> seen_from(const Transform<Scene, Body>& pose, Vector<Scene> v);
[[nodiscard]] RayFrame seen_from(const Transform<Scene, Body>& pose, const RayFrame& rays);
// And a body's plane in the scene.
[[nodiscard]] FixedPlane in_scene(const Transform<Scene, Body>& pose, const FixedPlane& plane);

// The rays as a mirror in the plane sends them on, unfolded: they start behind the mirror, and the ray parameter goes
// on counting from the camera.
[[nodiscard]] RayFrame mirrored(const RayFrame& rays, const FixedPlane& plane);

}  // namespace overfly
