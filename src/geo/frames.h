#pragma once

#include "core/angle.h"
#include "core/geometry.h"

namespace overfly {

// The frames of Overfly. Each is a tag for Point, Vector, Rotation and Transform; all are metres and right-handed.

// Earth-centred, earth-fixed, WGS84: x through (0 N, 0 E), z through the north pole.
struct Ecef;

// East, north, up at the scene's origin (scene_frame.h): the tangent plane of the ellipsoid there. The ellipsoid's
// curvature is in the coordinates: a point on the ellipsoid 100 km away has z = -785 m.
struct Scene;

// The camera: x to the right of the image, y DOWN the image, z along the view. (EXR's camera flips y; see io.)
struct Camera;

// A body that moves on its own, as its mesh is given: at heading, pitch and roll 0 x points east, y north (forward, the
// nose) and z up.
struct Body;

// A place on or above the WGS84 ellipsoid. Not a vector: degrees and metres do not mix.
struct Geodetic {
    Angle lon, lat;         // east and north positive; lon in any turn
    double height_m = 0.0;  // above the ellipsoid, along its normal

    friend constexpr bool operator==(const Geodetic&, const Geodetic&) = default;
};

}  // namespace overfly
