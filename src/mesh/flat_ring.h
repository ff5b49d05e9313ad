#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace overfly {

struct FlatPoint {
    double x = 0.0, y = 0.0;

    friend constexpr bool operator==(const FlatPoint&, const FlatPoint&) = default;
};

// A ring of at least three finite points in a plane, the last joined to the first.
using FlatRing = std::span<const FlatPoint>;

// A place where the ring crosses or touches itself, if there is one: GEOS decides it without rounding.
[[nodiscard]] std::optional<FlatPoint> crossing(FlatRing ring);

// As triangulate_polygon in polygon.h. REQUIRES: the ring has no crossing.
[[nodiscard]] std::vector<std::array<std::size_t, 3>> triangulate(FlatRing ring);

}  // namespace overfly
