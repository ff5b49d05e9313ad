#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "shade/colour_ramp.h"

namespace overfly {

// Colours by elevation as gdaldem's text files and GMT's .cpt tables say them: display values, as written.
struct ColourRelief {
    using Srgb = std::array<std::uint8_t, 3>;
    struct Entry {
        double value = 0.0;       // metres, or percent of the terrain's range
        bool is_percent = false;  // 0 is the lowest place, 100 the highest
        Srgb srgb{};

        friend bool operator==(const Entry&, const Entry&) = default;
    };
    std::vector<Entry> entries;   // as written, at least one
    std::optional<Srgb> no_data;  // "nv", or N of a .cpt

    friend bool operator==(const ColourRelief&, const ColourRelief&) = default;
};

// Reads `elevation R G B [A]` or `elevation name` a line (separated by spaces, tabs, commas, colons; `N%`, `nv`; names
// are GRASS's; `#` begins a comment), or a .cpt with RGB colours. Opacity is read and not used: terrain is opaque.
// Throws UserError with the line and column of everything that is wrong.
[[nodiscard]] ColourRelief read_colour_relief(const std::filesystem::path& file);

// The ramp in linear light for terrain that reaches from lowest_m to highest_m; entries sorted by elevation, those at
// one elevation left in the order of the file.
struct ElevationRange {
    double lowest_m = 0.0, highest_m = 0.0;
};
[[nodiscard]] ColourRamp colour_ramp(const ColourRelief& relief, ElevationRange range);

}  // namespace overfly
