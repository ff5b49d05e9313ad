#include "shade/hypsometric.h"

#include <algorithm>
#include <array>

namespace overfly {
namespace {

// Share of the way from the lowest to the highest ground, and the reflectance there as display-referred sRGB.
struct Share {
    float share;
    Rgb srgb;
};

constexpr std::array<Share, 8> kShares = {{{0.00F, {0.46F, 0.53F, 0.34F}},
                                           {0.12F, {0.63F, 0.62F, 0.41F}},
                                           {0.26F, {0.60F, 0.55F, 0.37F}},
                                           {0.40F, {0.38F, 0.43F, 0.27F}},
                                           {0.58F, {0.44F, 0.42F, 0.33F}},
                                           {0.72F, {0.56F, 0.52F, 0.47F}},
                                           {0.85F, {0.72F, 0.70F, 0.68F}},
                                           {1.00F, {0.95F, 0.95F, 0.97F}}}};

}  // namespace

ColourRamp hypsometric_ramp(float lowest_m, float highest_m) {
    ColourRamp ramp;
    // Flat ground still needs stops in ascending order.
    const float span = std::max(highest_m - lowest_m, 1.0F);
    for (const Share& s : kShares) {
        const Rgb linear = {linear_from_srgb(s.srgb.r), linear_from_srgb(s.srgb.g), linear_from_srgb(s.srgb.b)};
        ramp.stops.push_back({lowest_m + s.share * span, linear});
    }
    return ramp;
}

}  // namespace overfly
