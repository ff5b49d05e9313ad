#pragma once

#include <vector>

namespace overfly {

// How a pixel weighs what is seen around its middle; the same function across and down, multiplied.
enum class FilterKind { Box, Tent, BlackmanHarris, Mitchell };

// How wide a filter is unless something else is said, in pixels: 1, 2, 3, 4.
[[nodiscard]] double usual_width_px(FilterKind kind);

// One dimension of a pixel's filter, in pixels from the pixel's middle. Its integral is 1. Mitchell's (B = C = 1/3,
// Mitchell and Netravali 1988) is below zero in its outer half, nearly a thirtieth of it.
class PixelFilter {
  public:
    // width_px: of all that counts, positive.
    PixelFilter(FilterKind kind, double width_px);

    [[nodiscard]] double radius_px() const { return 0.5 * width_px_; }
    // How far the filter reaches over the edge of its pixel.
    [[nodiscard]] double margin_px() const { return radius_px() > 0.5 ? radius_px() - 0.5 : 0.0; }
    [[nodiscard]] double density(double x_px) const;
    // Its integral up to x, exact but for rounding.
    [[nodiscard]] double until(double x_px) const;

    struct Place {
        double x_px = 0.0;
        double weight = 1.0;
    };
    // Places spread by the filter, so that for even u in [0, 1) their weighted mean is the filter's. All weights are 1
    // but where a filter has parts below zero: a fifth of the places are there, and their weights are.
    [[nodiscard]] Place place(double u) const;
    // The same without what is below zero: for so few places that hardly any would be there.
    [[nodiscard]] Place place_above_zero(double u) const;

  private:
    [[nodiscard]] double at_part(double part) const;
    [[nodiscard]] double magnitude_until(double x_px) const;

    FilterKind kind_;
    double width_px_;
    double zero_px_;              // where it changes its sign
    double magnitude_ = 1.0;      // integral of its absolute value
    double below_zero_ = 0.0;     // part of that on either side that is below zero
    std::vector<double> places_;  // at even steps of the integral
};

// From so many places in a pixel on, PixelFilter::place serves.
inline constexpr double kPlacesForLobes = 16.0;

}  // namespace overfly
