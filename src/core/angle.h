#pragma once

#include <compare>
#include <numbers>

namespace overfly {

// An angle whose unit is stated where it is made and where it is read; there is no implicit double.
class Angle {
  public:
    constexpr Angle() = default;
    [[nodiscard]] static constexpr Angle degrees(double deg) { return Angle(deg * (std::numbers::pi / 180.0)); }
    [[nodiscard]] static constexpr Angle radians(double rad) { return Angle(rad); }

    [[nodiscard]] constexpr double degrees() const { return rad_ * (180.0 / std::numbers::pi); }
    [[nodiscard]] constexpr double radians() const { return rad_; }

    friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.rad_ + b.rad_); }
    friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.rad_ - b.rad_); }
    friend constexpr Angle operator-(Angle a) { return Angle(-a.rad_); }
    friend constexpr Angle operator*(double s, Angle a) { return Angle(s * a.rad_); }
    friend constexpr auto operator<=>(Angle, Angle) = default;

  private:
    constexpr explicit Angle(double rad) : rad_(rad) {}
    double rad_ = 0.0;
};

}  // namespace overfly
