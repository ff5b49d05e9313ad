#include "flight/body_shape.h"

#include <cmath>

#include "core/error.h"
#include "flight/place_curve.h"
#include "geo/scene_frame.h"

namespace overfly {
LonLat middle_of(const Outline& outline) {
    check(!outline.empty(), "an outline has a corner");
    Vector<Ecef> sum;
    for (const LonLat& corner : outline) sum = sum + ellipsoid_normal({corner.lon, corner.lat, 0.0});
    return {Angle::radians(std::atan2(sum.y, sum.x)), Angle::radians(std::atan2(sum.z, std::hypot(sum.x, sum.y)))};
}

Polygon level_polygon(const Outline& outline, const Geodetic& middle) {
    const SceneFrame at_middle(middle);
    Polygon polygon;
    for (const LonLat& corner : outline) {
        const Point<Scene> p = at_middle.scene({corner.lon, corner.lat, middle.height_m});
        polygon.push_back({p.x, p.y, 0.0});
    }
    return polygon;
}

}  // namespace overfly
