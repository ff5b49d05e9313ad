#include "shot/timeline_page.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace overfly {
namespace {

struct Colour {
    const char* hex;
    bool is_dark;
};

// Okabe and Ito 2008, "Color Universal Design", without the yellow, which is too pale for a line on white; ordered so
// that neighbours differ in lightness as well.
constexpr std::array<Colour, 6> kColours = {{{"#0072B2", true},
                                             {"#E69F00", false},
                                             {"#009E73", true},
                                             {"#CC79A7", false},
                                             {"#D55E00", true},
                                             {"#56B4E9", false}}};

// A to Z, AA to AZ, BA ...
std::string letter_of(std::size_t index) {
    std::string letters;
    for (std::size_t rest = index + 1; rest > 0; rest = (rest - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + static_cast<int>((rest - 1) % 26)));
    return letters;
}

}  // namespace

TimelinePage::TimelinePage(const PixelTimeline& pixel) : pixel_(&pixel) {
    for (const SightRecord& r : pixel.timeline.seen) {
        const std::size_t index = looks_.size();
        const Colour& colour = kColours[index % kColours.size()];
        looks_.try_emplace(r.what, TriangleLook{letter_of(index), colour.hex, colour.is_dark});
    }
}

const TriangleLook* TimelinePage::look_of(SurfaceTriangle what) const {
    const auto look = looks_.find(what);
    return look == looks_.end() ? nullptr : &look->second;
}

std::string TimelinePage::name_of(SurfaceTriangle what) const {
    return fmt::format("{} {}", what.surface == 0 ? "triangle" : pixel_->surfaces[what.surface], what.triangle);
}

double TimelinePage::x_at(double time_s) const {
    const TimeRange when = pixel_->timeline.when;
    return kLeft + (kRight - kLeft) * (time_s - when.begin_s) / when.duration_s();
}

std::string TimelinePage::time_text(double time_s) const {
    const double digits = std::ceil(-std::log10(pixel_->timeline.when.duration_s())) + 2.0;
    return fmt::format("{:.{}f}", time_s, static_cast<int>(std::clamp(digits, 1.0, 9.0)));
}

double round_step(double length, int most) {
    const double least = length / most;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * power >= least * (1.0 - 1e-9)) return step * power;
    }
    return 10.0 * power;
}

}  // namespace overfly
