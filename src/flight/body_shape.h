#pragma once

#include <variant>
#include <vector>

#include "flight/body_motion.h"
#include "mesh/mesh_source.h"
#include "mesh/polygon.h"

namespace overfly {

struct LonLat {
    Angle lon, lat;

    friend constexpr bool operator==(const LonLat&, const LonLat&) = default;
};

// The shore of a lake: corners on the Earth. The body is the level polygon at the place where it stands.
using Outline = std::vector<LonLat>;

// What a body is made of.
using BodyShape = std::variant<MeshSource, std::vector<Polygon>, Outline>;

// Where a body of this outline stands: the mean of the ellipsoid's normals at its corners.
// REQUIRES: at least one corner; all of them within a quarter of the Earth.
[[nodiscard]] LonLat middle_of(const Outline& outline);

// The outline as a polygon of a body that stands level at `middle`: each corner at the height of the middle, and then
// straight down, or up, into the plane that is level at the middle. That plane is above the level surface by the square
// of the distance over the Earth's diameter: 8 m at 10 km.
[[nodiscard]] Polygon level_polygon(const Outline& outline, const Geodetic& middle);

}  // namespace overfly
