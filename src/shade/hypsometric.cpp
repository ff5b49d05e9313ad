#include "shade/hypsometric.h"

#include <algorithm>
#include <array>
#include <span>

namespace overfly {
namespace {

// Share of the way from the lowest to the highest ground, and the reflectance there as display-referred sRGB.
struct Share {
    float share;
    Rgb srgb;
};

// After the belts of a dry continental range: the tree line lies at two thirds of its height. Belts end within a few
// posts, as in nature; that, and their straying, is what makes distance readable.
constexpr std::array kLevel = std::to_array<Share>({{0.00F, {0.62F, 0.57F, 0.40F}},  // dry grass
                                                    {0.09F, {0.71F, 0.64F, 0.48F}},  // basin floor
                                                    {0.20F, {0.69F, 0.60F, 0.42F}},  // sage and sand
                                                    {0.28F, {0.56F, 0.53F, 0.34F}},  // pinyon and juniper
                                                    {0.33F, {0.37F, 0.41F, 0.24F}},
                                                    {0.45F, {0.29F, 0.36F, 0.20F}},  // mixed forest
                                                    {0.64F, {0.22F, 0.31F, 0.18F}},  // spruce and fir
                                                    {0.68F, {0.43F, 0.45F, 0.28F}},  // tree line
                                                    {0.77F, {0.52F, 0.49F, 0.36F}},  // alpine meadow
                                                    {0.84F, {0.54F, 0.51F, 0.45F}},  // scree
                                                    {0.88F, {0.57F, 0.55F, 0.52F}},
                                                    {0.91F, {0.80F, 0.81F, 0.83F}}});  // snow
constexpr std::array kSteep = std::to_array<Share>({{0.00F, {0.58F, 0.48F, 0.34F}},    // cut bank
                                                    {0.28F, {0.49F, 0.43F, 0.29F}},    // thin soil
                                                    {0.45F, {0.29F, 0.33F, 0.20F}},    // forest with outcrops
                                                    {0.64F, {0.28F, 0.31F, 0.20F}},
                                                    {0.69F, {0.42F, 0.38F, 0.31F}},  // gneiss
                                                    {0.85F, {0.45F, 0.41F, 0.37F}},
                                                    {0.92F, {0.50F, 0.47F, 0.45F}},
                                                    {1.00F, {0.62F, 0.60F, 0.60F}}});  // with snow in the cracks

// How far the belts stray, as a share of the terrain's relief: 80 m in a range of 2 km.
constexpr float kStray = 0.04F;

std::vector<ColourRamp::Stop> spread(std::span<const Share> shares, float lowest_m, float highest_m) {
    // Flat ground still needs stops in ascending order.
    const float span_m = std::max(highest_m - lowest_m, 1.0F);
    std::vector<ColourRamp::Stop> stops;
    for (const Share& s : shares) {
        const Rgb linear = {linear_from_srgb(s.srgb.r), linear_from_srgb(s.srgb.g), linear_from_srgb(s.srgb.b)};
        stops.push_back({lowest_m + s.share * span_m, linear});
    }
    return stops;
}

}  // namespace

ColourRamp hypsometric_ramp(float lowest_m, float highest_m) {
    return {.stops = spread(kLevel, lowest_m, highest_m),
            .steep = spread(kSteep, lowest_m, highest_m),
            .stray_m = kStray * (highest_m - lowest_m)};
}

}  // namespace overfly
