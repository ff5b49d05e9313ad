#include "io/display.h"

#include <algorithm>
#include <cmath>

#include "core/colour.h"

namespace overfly {

float soft_highlight(float linear) {
    constexpr float kShoulder = 0.8F;
    constexpr float kRoom = 1.0F - kShoulder;
    if (linear <= kShoulder) return std::max(linear, 0.0F);
    // The exponential has slope 1 at the shoulder.
    return kShoulder + kRoom * (1.0F - std::exp((kShoulder - linear) / kRoom));
}

DisplayImage display_image(const Frame& frame) {
    DisplayImage image{.width = frame.width, .height = frame.height};
    image.rgb.reserve(3 * frame.rgba.size());
    for (const auto& rgba : frame.rgba) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const float srgb = srgb_from_linear(soft_highlight(rgba[channel]));
            image.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0F * srgb)));
        }
    }
    return image;
}

}  // namespace overfly
