#pragma once

#include <span>

#include "flight/spline.h"
#include "geo/frames.h"

namespace overfly {

// A smooth curve through places on or above the ellipsoid. Its ground track is a spline of the ellipsoid's unit normal
// (the n-vector of Gade 2010, A Non-singular Horizontal Position Representation), so there is nothing special about a
// pole or the antimeridian; its height is a spline of its own, so a level curve is level however far it reaches.
//
// GUARANTEES: those of Spline, for the normal before it is made a unit vector and for the height; C2.
class PlaceCurve {
  public:
    // REQUIRES: those of Spline; neighbours are no antipodes.
    PlaceCurve(std::span<const double> times_s, std::span<const Geodetic> places);

    [[nodiscard]] Geodetic at(double time_s) const;

  private:
    Spline<Vector<Ecef>> normal_;
    Spline<double> height_m_;
};

// The ellipsoid's outward unit normal at a place.
[[nodiscard]] Vector<Ecef> ellipsoid_normal(const Geodetic& place);

}  // namespace overfly
