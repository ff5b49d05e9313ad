#include "geo/geoid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace overfly {

double Geoid::undulation_m_at(Angle lon, Angle lat) const {
    // Columns repeat after a full turn; a column that repeats the first one is never looked at.
    const int columns_per_turn = static_cast<int>(std::lround(360.0 / step_lon_deg));
    const double turns = (lon.degrees() - west_deg) / 360.0;
    const double x = (turns - std::floor(turns)) * columns_per_turn;
    // Rows end at the poles, where every column has the same value.
    const double y = std::clamp((north_deg - lat.degrees()) / step_lat_deg, 0.0, static_cast<double>(rows - 1));

    const int column = static_cast<int>(x);
    const int row = std::min(static_cast<int>(y), std::max(rows - 2, 0));
    const double u = x - column, v = y - row;

    const auto sample = [&](int c, int r) -> double {
        const int wrapped = std::min(c % columns_per_turn, columns - 1);
        return undulation_m[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns) +
                            static_cast<std::size_t>(wrapped)];
    };
    const int below = std::min(row + 1, rows - 1);
    const double north_m = (1.0 - u) * sample(column, row) + u * sample(column + 1, row);
    const double south_m = (1.0 - u) * sample(column, below) + u * sample(column + 1, below);
    return (1.0 - v) * north_m + v * south_m;
}

}  // namespace overfly
