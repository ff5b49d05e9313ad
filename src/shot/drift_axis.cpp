#include "shot/drift_axis.h"

#include <cmath>

namespace overfly {

void DriftAxisChoice::add(const PictureChange& change) {
    const double height = std::hypot(change.right, change.down);
    if (height == 0.0) return;
    const double right = change.right / height, down = change.down / height;
    const double passing = (right * change.motion_right_px + down * change.motion_down_px) / drift_px_;
    const auto error = [&](double along, double across) {
        const double a = std::abs(across), l = std::abs(along - passing);
        return a > 0.0 ? height * height * a * a / (a + l) : 0.0;
    };
    error_x_ += error(right, down);
    error_y_ += error(down, right);
}

}  // namespace overfly
