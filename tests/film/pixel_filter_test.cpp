#include "film/pixel_filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overfly {
namespace {

constexpr FilterKind kKinds[] = {FilterKind::Box, FilterKind::Tent, FilterKind::BlackmanHarris, FilterKind::Mitchell};

template <class WithFilter>
void for_each_filter(const WithFilter& with_filter) {
    for (const FilterKind kind : kKinds) {
        for (const double width_px : {usual_width_px(kind), 1.7, 5.0}) {
            SCOPED_TRACE(testing::Message() << static_cast<int>(kind) << ", " << width_px << " px");
            with_filter(PixelFilter(kind, width_px));
        }
    }
}

TEST(PixelFilter, UntilIsTheIntegralOfTheDensity) {
    for_each_filter([](const PixelFilter& filter) {
        constexpr int kSteps = 40'000;
        const double step_px = 2.2 * filter.radius_px() / kSteps;
        double sum = 0.0;
        for (int k = 0; k < kSteps; ++k) {
            const double x_px = -1.1 * filter.radius_px() + (k + 0.5) * step_px;
            sum += filter.density(x_px) * step_px;
            ASSERT_NEAR(filter.until(x_px + 0.5 * step_px), sum, 1e-4);
        }
        EXPECT_NEAR(sum, 1.0, 1e-4);
        EXPECT_EQ(filter.until(-filter.radius_px()), 0.0);
        EXPECT_EQ(filter.until(filter.radius_px()), 1.0);
        EXPECT_NEAR(filter.until(0.0), 0.5, 1e-15);
    });
}

// What one place gives to all pixels around.
TEST(PixelFilter, OfUsualWidthShareEveryPlaceOut) {
    for (const FilterKind kind : kKinds) {
        const PixelFilter filter(kind, usual_width_px(kind));
        for (double at_px = 0.003; at_px < 1.0; at_px += 0.01) {
            double sum = 0.0;
            for (int pixel = -4; pixel <= 4; ++pixel) sum += filter.density(at_px - (pixel + 0.5));
            // Three places a period are one too few for the third wave of Blackman and Harris.
            EXPECT_NEAR(sum, 1.0, kind == FilterKind::BlackmanHarris ? 0.04 : 1e-12);
        }
    }
}

// Known values: the height in the middle, and the negative lobe.
TEST(PixelFilter, AreWhatTheirAuthorsSay) {
    EXPECT_NEAR(PixelFilter(FilterKind::Mitchell, 4.0).density(0.0), 8.0 / 9.0, 1e-15);
    EXPECT_NEAR(PixelFilter(FilterKind::Mitchell, 4.0).density(1.0), 1.0 / 18.0, 1e-15);
    EXPECT_LT(PixelFilter(FilterKind::Mitchell, 4.0).density(1.5), -0.03);
    EXPECT_NEAR(PixelFilter(FilterKind::BlackmanHarris, 3.0).density(0.0), 1.0 / (0.35875 * 3.0), 1e-12);
    EXPECT_NEAR(PixelFilter(FilterKind::Tent, 2.0).density(0.25), 0.75, 1e-15);
}

// Weighted places are the filter: up to each x they add up to the integral.
TEST(PixelFilter, PlacesAreSpreadByTheFilter) {
    for_each_filter([](const PixelFilter& filter) {
        constexpr int kPlaces = 20'000;
        for (double x_px = -filter.radius_px(); x_px < filter.radius_px(); x_px += 0.21) {
            double sum = 0.0, above_zero = 0.0;
            for (int k = 0; k < kPlaces; ++k) {
                const auto place = filter.place((k + 0.5) / kPlaces);
                if (place.x_px <= x_px) sum += place.weight / kPlaces;
                const auto only = filter.place_above_zero((k + 0.5) / kPlaces);
                EXPECT_GE(filter.density(only.x_px), -1e-3);
                EXPECT_EQ(only.weight > 0.0, true);
                if (only.x_px <= 0.0) above_zero += only.weight / kPlaces;
            }
            EXPECT_NEAR(sum, filter.until(x_px), 2e-3);
            EXPECT_NEAR(above_zero, 0.5, 1e-3);
        }
    });
}

}  // namespace
}  // namespace overfly
