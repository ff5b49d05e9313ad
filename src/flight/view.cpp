#include "flight/view.h"

namespace overfly {
namespace {

Vector<Scene> of_its_own(Vector<Body> v) { return {v.x, v.y, v.z}; }

Vector<Scene> mirrored(Vector<Scene> v, Vector<Scene> normal) { return v - 2.0 * dot(normal, v) * normal; }

}  // namespace

Point<Scene> seen_from(const Transform<Scene, Body>& pose, Point<Scene> p) {
    const Point<Body> seen = inverse(pose) * p;
    return {seen.x, seen.y, seen.z};
}

Vector<Scene> seen_from(const Transform<Scene, Body>& pose, Vector<Scene> v) {
    return of_its_own(inverse(pose.rotation) * v);
}

RayFrame seen_from(const Transform<Scene, Body>& pose, const RayFrame& rays) {
    return {seen_from(pose, rays.origin), seen_from(pose, rays.right), seen_from(pose, rays.down),
            seen_from(pose, rays.view)};
}

FixedPlane in_scene(const Transform<Scene, Body>& pose, const FixedPlane& plane) {
    return {pose * Point<Body>{plane.on.x, plane.on.y, plane.on.z},
            pose * Vector<Body>{plane.normal.x, plane.normal.y, plane.normal.z}};
}

RayFrame mirrored(const RayFrame& rays, const FixedPlane& plane) {
    return {rays.origin - 2.0 * dot(plane.normal, rays.origin - plane.on) * plane.normal,
            mirrored(rays.right, plane.normal), mirrored(rays.down, plane.normal), mirrored(rays.view, plane.normal)};
}

}  // namespace overfly
