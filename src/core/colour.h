#pragma once

#include <cmath>

namespace overfly {

// Linear light, Rec. 709 primaries, D65 white.
struct Rgb {
    float r = 0.0F, g = 0.0F, b = 0.0F;

    friend constexpr Rgb operator+(Rgb a, Rgb c) { return {a.r + c.r, a.g + c.g, a.b + c.b}; }
    friend constexpr Rgb operator*(Rgb a, Rgb c) { return {a.r * c.r, a.g * c.g, a.b * c.b}; }
    friend constexpr Rgb operator*(float s, Rgb a) { return {s * a.r, s * a.g, s * a.b}; }
    constexpr Rgb& operator+=(Rgb c) { return *this = *this + c; }
    friend constexpr bool operator==(Rgb, Rgb) = default;
};

// IEC 61966-2-1 (sRGB) transfer, both ways, on [0, 1].
[[nodiscard]] inline float linear_from_srgb(float v) {
    return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}
[[nodiscard]] inline float srgb_from_linear(float v) {
    return v <= 0.0031308F ? v * 12.92F : 1.055F * std::pow(v, 1.0F / 2.4F) - 0.055F;
}

}  // namespace overfly
