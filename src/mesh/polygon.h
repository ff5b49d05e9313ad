#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry.h"
#include "geo/frames.h"

namespace overfly {

// A planar ring of corners, convex or not, in either direction, the last joined to the first. In metres of the frame in
// which it stands still (triangle_mesh.h).
using Polygon = std::vector<Point<Scene>>;

// How far a corner may be off the polygon's plane, as a share of the polygon's size: what rounding to four digits does.
inline constexpr double kPlanar = 1e-4;

// Corners nearer than this share of the size to one line enclose nothing whose plane a double can tell.
inline constexpr double kOnOneLine = 1e-9;

// What keeps corners from being a polygon, as a message goes on after "got": fewer than three, two at the same point,
// all on one line, farther than kPlanar from one plane, sides that cross or touch. Nothing where they are one.
// REQUIRES: coordinates are finite, and below 1e100.
[[nodiscard]] std::optional<std::string> polygon_fault(std::span<const Point<Scene>> corners);

// The polygon as triangles of its own corners, by their places in the ring: the constrained Delaunay triangulation in
// its plane (GEOS), the one without needless slivers.
// REQUIRES: polygon_fault(corners) is nothing.
// GUARANTEES: two triangles less than corners; every corner is used, one in the middle of a straight side too; every
// side of the ring is a side of one triangle; the triangles run around the way that the ring does.
[[nodiscard]] std::vector<std::array<std::size_t, 3>> triangulate_polygon(std::span<const Point<Scene>> corners);

// The same for what files call a polygon: it may be uneven, and corners may be repeated one after another. Nothing
// where it has no area, or where its sides cross or touch as seen across its plane. REQUIRES: coordinates are finite,
// and below 1e100.
[[nodiscard]] std::optional<std::vector<std::array<std::size_t, 3>>> triangulate_uneven(
    std::span<const Point<Scene>> corners);

}  // namespace overfly
