#include "io/display.h"

#include <algorithm>
#include <cmath>

namespace overfly {

DisplayImage display_image(const Frame& frame, const ViewTransform& view) {
    std::vector<std::array<float, 4>> pixels = frame.rgba;
    view.apply(pixels);
    DisplayImage image{.width = frame.width, .height = frame.height};
    image.rgb.reserve(3 * pixels.size());
    for (const auto& pixel : pixels) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const float level = std::clamp(pixel[channel], 0.0F, 1.0F);
            image.rgb.push_back(static_cast<std::uint8_t>(std::lround(255.0F * level)));
        }
    }
    return image;
}

}  // namespace overfly
