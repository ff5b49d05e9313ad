#pragma once

#include <cmath>

#include "core/angle.h"

namespace overfly {

// A pinhole: the horizontal field of view, or a focal length before a sensor of a given width.
struct Lens {
    Angle horizontal_fov = Angle::degrees(60.0);  // (0, 180) degrees
    double sensor_width_mm = 36.0;                // for the headers; the picture depends on the field of view alone

    [[nodiscard]] double tan_half_fov() const { return std::tan(0.5 * horizontal_fov.radians()); }
    [[nodiscard]] double focal_length_mm() const { return 0.5 * sensor_width_mm / tan_half_fov(); }
    [[nodiscard]] static Lens of_focal_length(double focal_length_mm, double sensor_width_mm) {
        return {Angle::radians(2.0 * std::atan(0.5 * sensor_width_mm / focal_length_mm)), sensor_width_mm};
    }
    friend constexpr bool operator==(const Lens&, const Lens&) = default;
};

}  // namespace overfly
