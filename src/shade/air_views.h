#pragma once

#include <array>
#include <cstddef>

#include "core/colour.h"

namespace overfly {

// Many views through the air at once, in the layout that vector units like. What Daylight::through_air says of one
// goes for each, to the bit.
struct AirViews {
    static constexpr std::size_t kSize = 64;
    using Lane = std::array<float, kSize>;

    struct Path {
        float distance_m = 0.0F;
        float from_height_m = 0.0F, to_height_m = 0.0F;  // above the scene's lowest ground
        float towards_sun = 0.0F;                        // cosine of the view's angle to the sun
    };
    void set(std::size_t i, Rgb behind, const Path& path) {
        red[i] = behind.r;
        green[i] = behind.g;
        blue[i] = behind.b;
        distance_m[i] = path.distance_m;
        from_height_m[i] = path.from_height_m;
        to_height_m[i] = path.to_height_m;
        towards_sun[i] = path.towards_sun;
    }
    [[nodiscard]] Rgb seen(std::size_t i) const { return {red[i], green[i], blue[i]}; }

    // How much of what is behind the air comes through it. REQUIRES: look_through() has been.
    [[nodiscard]] Rgb share_left(std::size_t i) const { return {red_left[i], green_left[i], blue_left[i]}; }

    alignas(64) Lane red{}, green{}, blue{};  // what is behind the air; afterwards what is seen
    alignas(64) Lane red_left{}, green_left{}, blue_left{};
    alignas(64) Lane distance_m{}, from_height_m{}, to_height_m{}, towards_sun{};  // Path's
};

// What the views have in common.
struct Air {
    Rgb extinction_per_m;  // at the scene's lowest ground
    float scale_height_m = 1.0F;
    Rgb horizon;  // what haze tends to
    Rgb glow;     // more of it towards the sun, as a share of horizon
};

// The first `count` of them.
void look_through(const Air& air, AirViews& views, std::size_t count);

}  // namespace overfly
