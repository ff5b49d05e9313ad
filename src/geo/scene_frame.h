#pragma once

#include "geo/frames.h"

namespace overfly {

// The scene's place on the Earth, and the way between geodetic coordinates and scene metres through ECEF
// (GeographicLib::Geocentric; its error is below 10 nm within 5000 km of the surface).
class SceneFrame {
  public:
    explicit SceneFrame(Geodetic origin);

    [[nodiscard]] const Geodetic& origin() const { return origin_; }
    [[nodiscard]] const Transform<Scene, Ecef>& scene_from_ecef() const { return scene_from_ecef_; }

    [[nodiscard]] Point<Scene> scene(const Geodetic& place) const;
    [[nodiscard]] Geodetic geodetic(Point<Scene> p) const;

    // East, north and up of the ellipsoid at `place`, as the columns x, y and z, in scene coordinates.
    // The tag of the source is Scene as well: it is the same kind of frame at another place.
    [[nodiscard]] Rotation<Scene, Scene> local_axes(const Geodetic& place) const;

  private:
    Geodetic origin_;
    Transform<Scene, Ecef> scene_from_ecef_;
};

[[nodiscard]] Point<Ecef> ecef(const Geodetic& place);
[[nodiscard]] Geodetic geodetic(Point<Ecef> p);

// Length of the geodesic between two places on the ellipsoid, heights ignored, in metres (Karney 2013).
[[nodiscard]] double geodesic_length_m(const Geodetic& a, const Geodetic& b);

}  // namespace overfly
