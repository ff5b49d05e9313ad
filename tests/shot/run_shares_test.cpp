#include "shot/run_shares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>

namespace overfly {
namespace {

using Shape = ShutterCurve::Shape;

// Light along a run: straight, from one value to another.
constexpr double kLightAtBegin = 0.2, kLightAtEnd = 1.7;
double light_at(double v) { return kLightAtBegin + v * (kLightAtEnd - kLightAtBegin); }

struct Got {
    double light = 0.0, weight = 0.0;
};

std::map<std::uint32_t, Got> by_shares(const RunShares& shares) {
    std::map<std::uint32_t, Got> got;
    double begin_v = 0.0;
    std::size_t next = 0;
    for (const RunShares::Cell& cell : shares.cells) {
        const auto end_v = static_cast<double>(cell.end_v);
        const double mean = light_at(0.5 * (begin_v + end_v)), growth = light_at(end_v) - light_at(begin_v);
        for (; next < cell.end_share; ++next) {
            const RunShares::Share& share = shares.shares[next];
            const auto whole = static_cast<double>(share.whole);
            for (const RunShares::Row& row : shares.rows) {
                const auto weight = static_cast<double>(row.weight);
                Got& of = got[share.pixel + static_cast<std::uint32_t>(row.offset)];
                of.light += weight * (whole * mean + static_cast<double>(share.growth) * growth);
                of.weight += weight * whole;
            }
        }
        begin_v = end_v;
    }
    EXPECT_EQ(shares.cells.back().end_v, 1.0F);
    EXPECT_EQ(next, shares.shares.size());
    return got;
}

// Thousands of samples.
std::map<std::uint32_t, Got> by_samples(const Sweep& sweep, const ShutterCurve& curve, const PixelFilter& filter) {
    constexpr int kSamples = 50'000;
    std::map<std::uint32_t, Got> got;
    const double parts = sweep.to_part - sweep.from_part;
    for (int k = 0; k < kSamples; ++k) {
        const double v = (k + 0.5) / kSamples, px = sweep.from_px + v * sweep.length_px;
        const double open = sweep.weight * curve.openness(sweep.from_part + v * parts) * parts / kSamples;
        for (int at = sweep.first; at < sweep.end; ++at) {
            for (int row = sweep.first_row; row < sweep.end_row; ++row) {
                const bool is_at_rest = sweep.length_px == 0.0;
                const double along = is_at_rest ? 1.0 : filter.density(px - (at + 0.5));
                const double across = is_at_rest ? 1.0 : filter.density(sweep.across_px - (row + 0.5));
                if (along * across == 0.0) continue;
                const int offset = (at - sweep.first) * sweep.stride + (row - sweep.first_row) * sweep.row_stride;
                Got& of = got[sweep.first_pixel + static_cast<std::uint32_t>(offset)];
                of.light += open * along * across * light_at(v);
                of.weight += open * along * across;
            }
        }
    }
    return got;
}

const ShutterCurve kCurves[] = {
    {}, {Shape::Trapezoid, 0.25}, {Shape::Trapezoid, 0.1}, {Shape::Smooth, 0.25}, {Shape::Smooth, 0.5}};

void expect_the_samples(const Sweep& sweep, const PixelFilter* filter, double allowed) {
    const PixelFilter box(FilterKind::Box, 1.0);
    for (const ShutterCurve& curve : kCurves) {
        RunWeighing weighing(curve, filter);
        auto got = by_shares(weighing.of(sweep));
        const auto expected = by_samples(sweep, curve, filter != nullptr ? *filter : box);
        for (const auto& [pixel, of] : expected) {
            EXPECT_NEAR(got[pixel].light, of.light, allowed) << pixel;
            EXPECT_NEAR(got[pixel].weight, of.weight, allowed) << pixel;
        }
        for (const auto& [pixel, of] : got) EXPECT_NEAR(of.weight, 0.0, expected.contains(pixel) ? 10.0 : 1e-5);
    }
}

// A line that has 8 pixels for the whole exposure, of which this is a part; the row's last pixels get nothing.
constexpr Sweep kSweep = {.from_px = 3.37,
                          .length_px = 8.0 * 0.7,
                          .across_px = 6.2,
                          .from_part = 0.12,
                          .to_part = 0.82,
                          .first = 2,
                          .end = 8,
                          .first_row = 5,
                          .end_row = 9,
                          .first_pixel = 40,
                          .stride = 10};

constexpr double kRounding = 1e-4;  // of the samples' sum

TEST(RunWeighing, IsTheIntegralWithoutAFilter) {
    Sweep sweep = kSweep;
    sweep.end = 9;
    expect_the_samples(sweep, nullptr, kRounding);
}

TEST(RunWeighing, IsTheIntegralOfALineAtRest) {
    expect_the_samples({.from_part = 0.12, .to_part = 0.82, .weight = 0.5, .first_pixel = 7}, nullptr, kRounding);
}

TEST(RunWeighing, IsTheIntegralOfEveryFilter) {
    for (const FilterKind kind : {FilterKind::Tent, FilterKind::BlackmanHarris, FilterKind::Mitchell}) {
        const PixelFilter filter(kind, usual_width_px(kind));
        expect_the_samples(kSweep, &filter, 5e-4);
    }
}

// However the way is cut into runs.
TEST(RunWeighing, PartsAddUpToTheWhole) {
    const PixelFilter filter(FilterKind::Mitchell, 4.0);
    for (const ShutterCurve& curve : kCurves) {
        RunWeighing weighing(curve, &filter);
        std::map<std::uint32_t, double> whole, parts;
        for (const auto& [pixel, of] : by_shares(weighing.of(kSweep))) whole[pixel] = of.weight;
        for (int k = 0; k < 3; ++k) {
            Sweep part = kSweep;
            part.from_px += k * kSweep.length_px / 3;
            part.length_px /= 3;
            part.from_part += 0.7 * k / 3;
            part.to_part = part.from_part + 0.7 / 3;
            for (const auto& [pixel, of] : by_shares(weighing.of(part))) parts[pixel] += of.weight;
        }
        for (const auto& [pixel, weight] : whole) EXPECT_NEAR(parts[pixel], weight, 1e-4);
    }
}

TEST(RunWeighing, ABoxOfOnePixelNeedsNone) {
    EXPECT_TRUE(RunWeighing({}, nullptr).is_even());
    EXPECT_FALSE(RunWeighing({Shape::Smooth}, nullptr).is_even());
    const PixelFilter tent(FilterKind::Tent, 2.0);
    EXPECT_FALSE(RunWeighing({}, &tent).is_even());
}

}  // namespace
}  // namespace overfly
