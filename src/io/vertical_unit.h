#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace overfly {

// The length that one step of a raster's numbers stands for.
struct VerticalUnit {
    std::string name = "m";
    double metres = 1.0;

    friend bool operator==(const VerticalUnit&, const VerticalUnit&) = default;
};

// By the names that rasters, PROJ and people use, in any case: "m", "Metre", "ft", "us-ft", "US survey foot" ...
// The unit returned has our own short name.
[[nodiscard]] std::optional<VerticalUnit> vertical_unit_named(std::string_view name);

// The short names, for messages: "m, km, ...".
[[nodiscard]] std::string known_vertical_units();

}  // namespace overfly
