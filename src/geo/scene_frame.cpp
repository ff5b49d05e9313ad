#include "geo/scene_frame.h"

#include <vector>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>

namespace overfly {
namespace {

// East, north and up at `place`. GeographicLib hands out the matrix row by row, its columns are the axes.
Rotation<Ecef, Scene> ecef_from_local(const Geodetic& place) {
    double x_m = 0.0, y_m = 0.0, z_m = 0.0;
    std::vector<double> m(9);
    GeographicLib::Geocentric::WGS84().Forward(place.lat.degrees(), place.lon.degrees(), place.height_m, x_m, y_m, z_m,
                                               m);
    return {{m[0], m[3], m[6]}, {m[1], m[4], m[7]}, {m[2], m[5], m[8]}};
}

}  // namespace

SceneFrame::SceneFrame(Geodetic origin) : origin_(origin) {
    const Point<Ecef> o = ecef(origin);
    scene_from_ecef_ = inverse(Transform<Ecef, Scene>{ecef_from_local(origin), {o.x, o.y, o.z}});
}

Point<Scene> SceneFrame::scene(const Geodetic& place) const { return scene_from_ecef_ * ecef(place); }

Geodetic SceneFrame::geodetic(Point<Scene> p) const { return overfly::geodetic(inverse(scene_from_ecef_) * p); }

Rotation<Scene, Scene> SceneFrame::local_axes(const Geodetic& place) const {
    return scene_from_ecef_.rotation * ecef_from_local(place);
}

Point<Ecef> ecef(const Geodetic& place) {
    Point<Ecef> p;
    GeographicLib::Geocentric::WGS84().Forward(place.lat.degrees(), place.lon.degrees(), place.height_m, p.x, p.y, p.z);
    return p;
}

Geodetic geodetic(Point<Ecef> p) {
    double lat_deg = 0.0, lon_deg = 0.0, height_m = 0.0;
    GeographicLib::Geocentric::WGS84().Reverse(p.x, p.y, p.z, lat_deg, lon_deg, height_m);
    return {Angle::degrees(lon_deg), Angle::degrees(lat_deg), height_m};
}

double geodesic_length_m(const Geodetic& a, const Geodetic& b) {
    double length_m = 0.0;
    GeographicLib::Geodesic::WGS84().Inverse(a.lat.degrees(), a.lon.degrees(), b.lat.degrees(), b.lon.degrees(),
                                             length_m);
    return length_m;
}

}  // namespace overfly
