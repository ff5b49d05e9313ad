#include "mesh/polygon.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "mesh/corner_plane.h"

namespace overfly {
namespace {

std::optional<std::pair<std::size_t, std::size_t>> same_corners(std::span<const Point<Scene>> corners) {
    std::vector<std::size_t> order(corners.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {},
                      [&](std::size_t i) { return std::tuple(corners[i].x, corners[i].y, corners[i].z, i); });
    const auto same = [&](std::size_t i, std::size_t j) { return corners[i] == corners[j]; };
    const auto pair = std::ranges::adjacent_find(order, same);
    if (pair == order.end()) return std::nullopt;
    return std::pair(pair[0], pair[1]);
}

std::optional<std::string> planarity_fault(std::span<const Point<Scene>> corners, const CornerPlane& plane) {
    std::vector<double> offsets_m;
    for (const Point<Scene>& p : corners) offsets_m.push_back(dot(plane.normal, p - corners.front()));
    const auto [low, high] = std::ranges::minmax_element(offsets_m);
    const double farthest_m = 0.5 * (*high - *low);  // from the plane in the middle
    const double allowed_m = kPlanar * plane.size_m;
    if (farthest_m <= allowed_m) return std::nullopt;
    const auto worst = std::abs(*low) > std::abs(*high) ? low : high;
    return fmt::format("corners up to {:.4g} m off one plane (corner {} is), allowed {:.4g} m, {} of its size",
                       farthest_m, worst - offsets_m.begin(), allowed_m, kPlanar);
}

std::optional<std::string> crossing_fault(const std::vector<FlatPoint>& ring) {
    const std::optional<FlatPoint> where = crossing(ring);
    if (!where) return std::nullopt;
    const auto nearest = std::ranges::min_element(
        ring, {}, [&](const FlatPoint& p) { return std::hypot(p.x - where->x, p.y - where->y); });
    return fmt::format("sides that cross or touch near corner {}, allowed a ring that keeps clear of itself",
                       nearest - ring.begin());
}

}  // namespace

std::optional<std::string> polygon_fault(std::span<const Point<Scene>> corners) {
    if (corners.size() < 3) return fmt::format("{} corners, allowed at least 3", corners.size());
    if (const auto same = same_corners(corners)) {
        return fmt::format(
            "corners {} and {} at the same point, allowed different ones (the last is joined to the first)",
            same->first, same->second);
    }
    const CornerPlane plane = corner_plane(corners);
    if (plane.width_m <= kOnOneLine * plane.size_m) return "corners on one line, allowed what has an area";
    if (auto fault = planarity_fault(corners, plane)) return fault;
    return crossing_fault(flattened(corners, plane.normal));
}

std::vector<std::array<std::size_t, 3>> triangulate_polygon(std::span<const Point<Scene>> corners) {
    return triangulate(flattened(corners, corner_plane(corners).normal));
}

std::optional<std::vector<std::array<std::size_t, 3>>> triangulate_uneven(std::span<const Point<Scene>> corners) {
    // Files repeat a corner where they want a triangle to look like a quadrilateral.
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (corners[i] != corners[(i + 1) % corners.size()]) kept.push_back(i);
    if (kept.size() < 3) return std::nullopt;
    Polygon ring;
    for (const std::size_t i : kept) ring.push_back(corners[i]);
    const CornerPlane plane = corner_plane(ring);
    if (plane.width_m <= kOnOneLine * plane.size_m) return std::nullopt;
    const std::vector<FlatPoint> flat = flattened(ring, plane.normal);
    if (std::ranges::adjacent_find(flat) != flat.end() || flat.front() == flat.back() || crossing(flat))
        return std::nullopt;
    std::vector<std::array<std::size_t, 3>> triangles = triangulate(flat);
    for (auto& triangle : triangles)
        for (std::size_t& corner : triangle) corner = kept[corner];
    return triangles;
}

}  // namespace overfly
