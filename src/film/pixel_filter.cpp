#include "film/pixel_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace overfly {
namespace {

// Between two steps places are interpolated: the filter is then off by less than a thousandth of its height.
constexpr std::size_t kSteps = 4096;

// Of all places, on either side, where the filter is below zero. It has a sixtieth of its integral there, but one place
// of sixty would tell nothing of what is seen.
constexpr double kPlacesBelowZero = 0.1;

// Harris 1978, "On the Use of Windows", the four-term window of least sidelobes.
constexpr std::array<double, 4> kBlackmanHarris = {0.35875, 0.48829, 0.14128, 0.01168};

// Mitchell's filter has its zero at 8/7 of a quarter of its width: (t - 2)^2 (8/7 - t) 7/18 from t = 1 on.
constexpr double kMitchellZero = 8.0 / 7.0;

double mitchell(double t) {
    if (t < 1.0) return ((7.0 * t - 12.0) * t * t + 16.0 / 3.0) / 6.0;
    return (2.0 - t) * (2.0 - t) * (kMitchellZero - t) * 7.0 / 18.0;
}

// Its integral from 0 on, 1/2 at 2.
double mitchell_until(double t) {
    if (t < 1.0) return ((7.0 / 4.0 * t - 4.0) * t * t + 16.0 / 3.0) * t / 6.0;
    const double left = 2.0 - t;
    return 0.5 + 7.0 / 18.0 * left * left * left * (2.0 / 7.0 - 0.25 * left);
}

}  // namespace

double usual_width_px(FilterKind kind) {
    switch (kind) {
        case FilterKind::Box:
            return 1.0;
        case FilterKind::Tent:
            return 2.0;
        case FilterKind::BlackmanHarris:
            return 3.0;
        case FilterKind::Mitchell:
            return 4.0;
    }
    return 1.0;
}

PixelFilter::PixelFilter(FilterKind kind, double width_px)
    : kind_(kind),
      width_px_(width_px),
      zero_px_(kind == FilterKind::Mitchell ? 0.25 * width_px * kMitchellZero : 0.5 * width_px) {
    const double outside = 1.0 - until(zero_px_);  // not above zero
    magnitude_ = 1.0 - 4.0 * outside;
    below_zero_ = std::max(0.0, -outside / magnitude_);
    places_.resize(kSteps + 1);
    for (std::size_t i = 0; i <= kSteps; ++i) {
        const double wanted = magnitude_ * static_cast<double>(i) / kSteps;
        double low = -radius_px(), high = radius_px();
        constexpr int kHalvings = 50;
        for (int k = 0; k < kHalvings; ++k) {
            const double middle = 0.5 * (low + high);
            (magnitude_until(middle) < wanted ? low : high) = middle;
        }
        places_[i] = 0.5 * (low + high);
    }
}

double PixelFilter::density(double x_px) const {
    const double x = std::abs(x_px) / width_px_;  // up to 1/2
    if (x >= 0.5) return 0.0;
    switch (kind_) {
        case FilterKind::Box:
            return 1.0 / width_px_;
        case FilterKind::Tent:
            return (2.0 - 4.0 * x) / width_px_;
        case FilterKind::Mitchell:
            return 4.0 * mitchell(4.0 * x) / width_px_;
        case FilterKind::BlackmanHarris:
            break;
    }
    const double c = std::cos(2.0 * std::numbers::pi * x);
    const auto& [a0, a1, a2, a3] = kBlackmanHarris;
    return (a0 + a1 * c + a2 * (2.0 * c * c - 1.0) + a3 * (4.0 * c * c - 3.0) * c) / (a0 * width_px_);
}

double PixelFilter::until(double x_px) const {
    const double x = x_px / width_px_;
    if (x <= -0.5) return 0.0;
    if (x >= 0.5) return 1.0;
    switch (kind_) {
        case FilterKind::Box:
            return 0.5 + x;
        case FilterKind::Tent:
            return x < 0.0 ? 2.0 * (x + 0.5) * (x + 0.5) : 1.0 - 2.0 * (0.5 - x) * (0.5 - x);
        case FilterKind::Mitchell:
            return 0.5 + std::copysign(mitchell_until(4.0 * std::abs(x)), x);
        case FilterKind::BlackmanHarris:
            break;
    }
    const double angle = 2.0 * std::numbers::pi * x;
    const double s = std::sin(angle), c = std::cos(angle);
    const auto& [a0, a1, a2, a3] = kBlackmanHarris;
    const double waves = a1 * s + a2 * s * c + a3 * (s - 4.0 / 3.0 * s * s * s);
    return 0.5 + x + waves / (2.0 * std::numbers::pi * a0);
}

double PixelFilter::magnitude_until(double x_px) const {
    const double outside = until(-zero_px_);
    if (x_px < -zero_px_) return -until(x_px);
    if (x_px < zero_px_) return until(x_px) - 2.0 * outside;
    return -2.0 * outside + 2.0 * until(zero_px_) - until(x_px);
}

PixelFilter::Place PixelFilter::place(double u) const {
    if (below_zero_ <= 0.0) return {at_part(u), 1.0};
    const double from_end = std::min(u, 1.0 - u);
    const double of_lobe = from_end / kPlacesBelowZero;  // below 1: in it
    if (of_lobe < 1.0) {
        const double part = below_zero_ * of_lobe;
        return {at_part(u < 0.5 ? part : 1.0 - part), -magnitude_ * below_zero_ / kPlacesBelowZero};
    }
    const double above_zero = 1.0 - 2.0 * below_zero_, places = 1.0 - 2.0 * kPlacesBelowZero;
    return {at_part(below_zero_ + (u - kPlacesBelowZero) / places * above_zero), magnitude_ * above_zero / places};
}

PixelFilter::Place PixelFilter::place_above_zero(double u) const {
    return {at_part(below_zero_ + u * (1.0 - 2.0 * below_zero_)), 1.0};
}

double PixelFilter::at_part(double part) const {
    const double at = part * kSteps;
    const std::size_t step = std::min(static_cast<std::size_t>(at), kSteps - 1);
    return places_[step] + (at - static_cast<double>(step)) * (places_[step + 1] - places_[step]);
}

}  // namespace overfly
