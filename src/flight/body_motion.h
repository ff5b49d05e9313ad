#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "flight/keyframe.h"

namespace overfly {

// c0 + c1 t + c2 t^2 + ... of the time in seconds; without coefficients, 0.
struct TimePolynomial {
    std::vector<double> coefficients;

    [[nodiscard]] double at(double time_s) const {
        double value = 0.0;
        for (std::size_t k = coefficients.size(); k-- > 0;) value = value * time_s + coefficients[k];
        return value;
    }
    [[nodiscard]] bool is_constant() const {
        for (std::size_t k = 1; k < coefficients.size(); ++k)
            if (coefficients[k] != 0.0) return false;
        return true;
    }
    friend bool operator==(const TimePolynomial&, const TimePolynomial&) = default;
};

// A body near a place. The distances are along east, north and up of the ellipsoid at the place itself, wherever the
// body has got to: linear polynomials are a straight line in space. The angles are those of Attitude, against the
// horizon of the place.
struct BodyPolynomials {
    FlightPlace place;
    TimePolynomial east_m, north_m, up_m;
    TimePolynomial heading_deg, pitch_deg, roll_deg;

    friend bool operator==(const BodyPolynomials&, const BodyPolynomials&) = default;
};

// A body that flies a flight's keyframes as a camera would, its nose where that looks. It is at the flight's time
// t - delay_s at the time t.
struct BodyFlight {
    std::vector<Keyframe> keyframes;
    double delay_s = 0.0;

    friend bool operator==(const BodyFlight&, const BodyFlight&) = default;
};

// How a body moves. Time is that of the camera's flight: what its keyframes count, from their own zero.
using BodyMotion = std::variant<BodyPolynomials, BodyFlight>;

}  // namespace overfly
