#include "shade/body_light.h"

#include <algorithm>
#include <cmath>

#include "shade/ground_light.h"

namespace overfly {

MattLight matt_light(Rgb albedo, const Incidence& at, const Daylight& day) {
    const auto facing_sun = static_cast<float>(std::max(dot(at.normal, at.to_sun), 0.0));
    // A plane sees this share of the sky over an open horizon, weighted by cosine; the rest is ground.
    const auto of_sky = static_cast<float>(0.5 * (1.0 + std::clamp(dot(at.normal, at.up), -1.0, 1.0)));
    return {albedo * (facing_sun * day.sun()), albedo * (of_sky * day.sky() + (1.0F - of_sky) * ground_around(day))};
}

double mirrored_share(double share_straight, double cos_to_normal) {
    const double grazing = 1.0 - std::clamp(cos_to_normal, 0.0, 1.0);
    return share_straight + (1.0 - share_straight) * std::pow(grazing, 5.0);
}

}  // namespace overfly
