#include "film/frame_error.h"

#include <cmath>
#include <cstddef>

namespace overfly {

double root_mean_square(const Frame& a, const Frame& b, const std::function<bool(int x, int y)>& where) {
    double sum = 0.0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        const int x = static_cast<int>(i) % a.width, y = static_cast<int>(i) / a.width;
        if (where && !where(x, y)) continue;
        ++pixels;
        for (std::size_t c = 0; c < 3; ++c) {
            const double difference = static_cast<double>(a.rgba[i][c]) - static_cast<double>(b.rgba[i][c]);
            sum += difference * difference;
        }
    }
    return std::sqrt(sum / (3.0 * static_cast<double>(pixels)));
}

}  // namespace overfly
