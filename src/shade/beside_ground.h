#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace overfly {

// Samples without ground that are beside one with ground take what it has: rounding may look a little past an edge.
// Calls copy(to, from) with indices of samples, row by row; of several neighbours, the last one tells.
template <class Copy>
void fill_beside(const std::vector<std::uint8_t>& is_known, int raster_columns, const Copy& copy) {
    const auto columns = static_cast<std::size_t>(raster_columns);
    const std::size_t count = is_known.size(), rows = count / columns;
    for (std::size_t i = 0; i < count; ++i) {
        if (is_known[i] != 0) continue;
        const std::size_t row = i / columns, column = i % columns;
        for (std::size_t r = row > 0 ? row - 1 : 0; r < std::min(row + 2, rows); ++r) {
            for (std::size_t c = column > 0 ? column - 1 : 0; c < std::min(column + 2, columns); ++c) {
                const std::size_t beside = r * columns + c;
                if (is_known[beside] != 0) copy(i, beside);
            }
        }
    }
}

}  // namespace overfly
