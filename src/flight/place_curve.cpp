#include "flight/place_curve.h"

#include <cmath>
#include <vector>

namespace overfly {
namespace {

std::vector<Vector<Ecef>> normals(std::span<const Geodetic> places) {
    std::vector<Vector<Ecef>> result;
    for (const Geodetic& place : places) result.push_back(ellipsoid_normal(place));
    return result;
}

std::vector<double> heights_m(std::span<const Geodetic> places) {
    std::vector<double> result;
    for (const Geodetic& place : places) result.push_back(place.height_m);
    return result;
}

}  // namespace

Vector<Ecef> ellipsoid_normal(const Geodetic& place) {
    const double lon = place.lon.radians(), lat = place.lat.radians();
    return {std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
}

PlaceCurve::PlaceCurve(std::span<const double> times_s, std::span<const Geodetic> places)
    : normal_(times_s, normals(places)), height_m_(times_s, heights_m(places)) {}

Geodetic PlaceCurve::at(double time_s) const {
    // The arc tangents need no unit vector.
    const Vector<Ecef> n = normal_.at(time_s);
    return {Angle::radians(std::atan2(n.y, n.x)), Angle::radians(std::atan2(n.z, std::hypot(n.x, n.y))),
            height_m_.at(time_s)};
}

}  // namespace overfly
