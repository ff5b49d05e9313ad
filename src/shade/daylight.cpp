#include "shade/daylight.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/low_discrepancy.h"
#include "shade/fast_exp.h"

namespace overfly {
namespace {

// Haze thins out with height by 1/e in this many metres: between dry dust (1 to 2 km) and the air itself (8 km).
constexpr float kHazeScaleHeight_m = 2'500.0F;

// -ln 0.02: where haze leaves 2 % of the contrast is called the visibility (Koschmieder 1924).
constexpr double kKoschmieder = 3.912;

// Short waves scatter more: (wavelength / 550 nm)^-1.3 at 610, 550 and 465 nm, with Angstrom's mean exponent (1929).
constexpr Rgb kExtinctionByColour = {0.87F, 1.0F, 1.24F};

// Optical depth of the air above 2.4 km, straight up, at the same wavelengths: Rayleigh's (Hansen and Travis 1974) at
// 0.75 of the pressure at sea level, and 0.02 um^1.3 of aerosol. Colours are balanced for a sun at the zenith.
constexpr Rgb kDepthOfAir = {0.086F, 0.117F, 0.199F};

constexpr float kWhiteUnderSun = 2.0F;  // the unit of light, see the header

// Radiance of a clear sky as a share of that of white ground under the zenith sun, chosen so that level ground under a
// high sun gets an eighth of its light from the sky, as in clear mountain air.
constexpr Rgb kZenith = {0.028F, 0.072F, 0.180F};
constexpr Rgb kHorizon = {0.215F, 0.270F, 0.340F};
// Share of the horizon's light that comes there straight from the sun and is reddened as the sun is.
constexpr float kSunInHaze = 0.5F;

// Light scattered forward around the sun, cos^8 of the angle: half as wide as Mie scattering of haze, which is what
// shows against a horizon that contains its wide part already.
constexpr float kGlow = 0.8F;
constexpr Rgb kGlowColour = {1.0F, 0.84F, 0.62F};

Rgb mix(Rgb a, Rgb b, float share_of_b) { return (1.0F - share_of_b) * a + share_of_b * b; }

// Air between the place and the edge of the atmosphere towards a sun at this elevation, in zeniths (Kasten, Young
// 1989).
double air_mass(double elevation_rad) {
    const double above_deg = std::max(elevation_rad, 0.0) * 180.0 / std::numbers::pi;
    return 1.0 / (std::sin(std::max(elevation_rad, 0.0)) + 0.50572 * std::pow(above_deg + 6.07995, -1.6364));
}

Rgb left_of_sun(double elevation_rad) {
    const auto more = static_cast<float>(air_mass(elevation_rad) - 1.0);
    return {std::exp(-more * kDepthOfAir.r), std::exp(-more * kDepthOfAir.g), std::exp(-more * kDepthOfAir.b)};
}

}  // namespace

Daylight::Daylight(const Look& look) {
    const double azimuth = look.sun_azimuth.radians();
    const double elevation = look.sun_elevation.radians();
    to_sun_ = {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
    const float unit = kWhiteUnderSun * static_cast<float>(std::exp2(look.exposure_stops));
    const Rgb sunlight = left_of_sun(elevation);
    const auto is_up = elevation > 0.0 ? 1.0F : 0.0F;
    sun_ = (unit * is_up * static_cast<float>(look.sun_strength)) * sunlight;
    // The sky stays as bright as by day until the sun is near the horizon; below it is twilight.
    const float day = 0.15F + 0.85F * static_cast<float>(std::clamp(4.0 * std::sin(elevation) + 0.3, 0.0, 1.0));
    const float sky_unit = unit * static_cast<float>(look.sky_strength) * day;
    zenith_ = sky_unit * kZenith;
    air_.horizon = sky_unit * (kHorizon * mix({1.0F, 1.0F, 1.0F}, (1.0F / sunlight.g) * sunlight, kSunInHaze));
    const double per_m = look.visibility_m > 0.0 ? kKoschmieder / look.visibility_m : 0.0;
    air_.extinction_per_m = static_cast<float>(per_m) * kExtinctionByColour;
    air_.scale_height_m = kHazeScaleHeight_m;
    air_.glow = kGlow * kGlowColour;

    // Cosine-weighted directions: their mean is the irradiance of level ground over pi.
    constexpr std::uint32_t kDirections = 1024;
    for (std::uint32_t i = 0; i < kDirections; ++i) {
        const auto p = low_discrepancy_point(0, i);
        const double turn = 2.0 * std::numbers::pi * p[1];
        const double level = std::sqrt(p[0]);
        const Vector<Scene> d = {level * std::cos(turn), level * std::sin(turn), std::sqrt(1.0 - p[0])};
        sky_ += (1.0F / static_cast<float>(kDirections)) * background(d, {0.0, 0.0, 1.0});
    }
}

Rgb Daylight::horizon(Vector<Scene> direction) const {
    const auto towards_sun = static_cast<float>(std::max(dot(direction, to_sun_), 0.0));
    const float power2 = towards_sun * towards_sun;
    const float power4 = power2 * power2;
    return air_.horizon * (Rgb{1.0F, 1.0F, 1.0F} + power4 * power4 * air_.glow);
}

Rgb Daylight::background(Vector<Scene> direction, Vector<Scene> up) const {
    const auto rise = static_cast<float>(std::max(dot(direction, up), 0.0));
    return mix(zenith_, horizon(direction), fast_exp(-rise / kSkyRise));
}

Rgb Daylight::through_air(Rgb behind, const AirPath& path, Vector<Scene> direction) const {
    const AirShare air = share_of_air(path, direction);
    return behind * air.left + air.haze;
}

Daylight::AirShare Daylight::share_of_air(const AirPath& path, Vector<Scene> direction) const {
    // Mean density along the path of an atmosphere exponential in height: with a the lower and b the higher end in
    // scale heights, (e^-a - e^-b) / (b - a).
    const float a = static_cast<float>(std::min(path.from_height_m, path.to_height_m)) / air_.scale_height_m;
    const float b = static_cast<float>(std::max(path.from_height_m, path.to_height_m)) / air_.scale_height_m;
    const float difference = b - a;
    const Float4 at = fast_exp(Float4{-std::max(a, 0.0F), -difference, 0.0F, 0.0F});
    // Below 0.01 the quotient loses digits, and the first two terms of its series are within 2e-5.
    const float mean = difference > 0.01F ? (1.0F - at[1]) / difference : 1.0F - 0.5F * difference;
    const float amount = at[0] * mean * static_cast<float>(path.distance_m);
    const Rgb depth = amount * air_.extinction_per_m;
    const Float4 left_of = fast_exp(Float4{-depth.r, -depth.g, -depth.b, 0.0F});
    const Rgb left = {left_of[0], left_of[1], left_of[2]};
    return {left, horizon(direction) * Rgb{1.0F - left.r, 1.0F - left.g, 1.0F - left.b}};
}

Vector<Scene> up_at(Point<Scene> p) { return normalized(Vector<Scene>{p.x, p.y, p.z + kEarthRadius_m}); }

double height_over_ball_m(Point<Scene> p) {
    return length(Vector<Scene>{p.x, p.y, p.z + kEarthRadius_m}) - kEarthRadius_m;
}

std::optional<double> distance_to_ball_m(Point<Scene> p, Vector<Scene> direction, double height_m) {
    const Vector<Scene> from_middle = {p.x, p.y, p.z + kEarthRadius_m};
    const double sinking = -dot(from_middle, direction);
    const double radius_m = kEarthRadius_m + height_m;
    const double beyond_m2 = dot(from_middle, from_middle) - radius_m * radius_m;
    const double square = sinking * sinking - beyond_m2;
    if (sinking <= 0.0 || square < 0.0) return std::nullopt;
    return beyond_m2 / (sinking + std::sqrt(square));
}

}  // namespace overfly
