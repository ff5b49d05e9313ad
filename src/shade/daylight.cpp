#include "shade/daylight.h"

#include <algorithm>
#include <cmath>

namespace overfly {
namespace {

constexpr double kEarthRadius_m = 6'371'008.8;  // mean radius (IUGG)

// Haze thins out with height by 1/e in this many metres: between dry dust and water vapour.
constexpr double kHazeScaleHeight_m = 2'500.0;

// -ln 0.02: where haze leaves 2 % of the contrast is called the visibility (Koschmieder 1924).
constexpr double kKoschmieder = 3.912;

// Short waves scatter more. Ratios at 610, 550 and 465 nm of an Angstrom exponent of 1.3, a clear mountain day.
constexpr Rgb kExtinctionByColour = {0.87F, 1.0F, 1.24F};

// Glow of the haze around the sun.
constexpr float kGlow = 0.55F;
constexpr double kGlowSharpness = 6.0;

Rgb mix(Rgb a, Rgb b, float share_of_b) { return (1.0F - share_of_b) * a + share_of_b * b; }

}  // namespace

Daylight::Daylight(const Look& look) {
    const double azimuth = look.sun_azimuth.radians();
    const double elevation = look.sun_elevation.radians();
    to_sun_ = {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
    const auto exposure = static_cast<float>(std::exp2(look.exposure_stops));
    // A low sun is dimmer and warmer: its light crosses more air. 1 / sin with a floor at the horizon's air mass of 38.
    const double air_mass = 1.0 / std::max(std::sin(elevation), 1.0 / 38.0);
    const auto left = [&](double depth) { return static_cast<float>(std::exp(-depth * (air_mass - 1.0))); };
    const auto is_up = elevation > 0.0 ? 1.0F : 0.0F;
    const Rgb sunlight = {left(0.020), 0.955F * left(0.045), 0.88F * left(0.090)};
    sun_ = (exposure * is_up * static_cast<float>(look.sun_strength)) * (1.25F * sunlight);
    const auto sky_strength = exposure * static_cast<float>(look.sky_strength);
    const float day = 0.15F + 0.85F * static_cast<float>(std::clamp(4.0 * std::sin(elevation) + 0.3, 0.0, 1.0));
    sky_ = (sky_strength * day) * Rgb{0.17F, 0.23F, 0.33F};
    zenith_ = (sky_strength * day) * Rgb{0.085F, 0.19F, 0.44F};
    horizon_ = (sky_strength * day) * mix(Rgb{0.52F, 0.62F, 0.74F}, sunlight, 0.25F);
    const double per_m = look.visibility_m > 0.0 ? kKoschmieder / look.visibility_m : 0.0;
    extinction_per_m_ = static_cast<float>(per_m) * kExtinctionByColour;
}

Rgb Daylight::horizon(Vector<Scene> direction) const {
    const double towards_sun = std::max(dot(direction, to_sun_), 0.0);
    const auto glow = kGlow * static_cast<float>(std::pow(towards_sun, kGlowSharpness));
    return horizon_ + glow * (horizon_ * Rgb{1.0F, 0.86F, 0.66F});
}

Rgb Daylight::background(Vector<Scene> direction, Vector<Scene> up) const {
    const double rise = std::max(dot(direction, up), 0.0);
    const auto clear = static_cast<float>(1.0 - std::exp(-rise / 0.16));
    return mix(horizon(direction), zenith_, clear);
}

Rgb Daylight::through_air(Rgb behind, const AirPath& path, Vector<Scene> direction) const {
    // Mean density along the path of an atmosphere exponential in height.
    const double from = path.from_height_m / kHazeScaleHeight_m;
    const double to = path.to_height_m / kHazeScaleHeight_m;
    const double difference = to - from;
    const double density =
        std::abs(difference) > 1e-6 ? (std::exp(-from) - std::exp(-to)) / difference : std::exp(-0.5 * (from + to));
    const auto amount = static_cast<float>(density * path.distance_m);
    const Rgb left = {std::exp(-amount * extinction_per_m_.r), std::exp(-amount * extinction_per_m_.g),
                      std::exp(-amount * extinction_per_m_.b)};
    const Rgb air = horizon(direction);
    return behind * left + air * Rgb{1.0F - left.r, 1.0F - left.g, 1.0F - left.b};
}

Vector<Scene> up_at(Point<Scene> p) { return normalized(Vector<Scene>{p.x, p.y, p.z + kEarthRadius_m}); }

double height_over_ball_m(Point<Scene> p) {
    return length(Vector<Scene>{p.x, p.y, p.z + kEarthRadius_m}) - kEarthRadius_m;
}

}  // namespace overfly
