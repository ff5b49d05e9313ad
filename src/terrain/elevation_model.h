#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace overfly {

// A grid of heights as measured, without a place: row 0 is the raster's first row. A sample that was never measured is
// masked; no height value has a special meaning.
struct ElevationModel {
    int columns = 0, rows = 0;
    std::vector<float> height_m;         // above the document's vertical datum, row by row
    std::vector<std::uint8_t> is_valid;  // 1 where measured

    [[nodiscard]] std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    }
    [[nodiscard]] std::size_t size() const { return height_m.size(); }
};

}  // namespace overfly
