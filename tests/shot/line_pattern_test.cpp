#include "shot/line_pattern.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace overfly {
namespace {

constexpr PictureSize kSize = {64, 36};

// However a stretch of one pixel is laid, it has `per_pixel` lines in it: so does every pixel at all times.
TEST(LinePattern, EveryPixelHasItsLinesWhereverTheyHaveDriftedTo) {
    for (const int per_pixel : {1, 2, 3, 8}) {
        const LinePattern pattern = {kSize, DriftAxis::X, per_pixel};
        for (double from_px = -3.0; from_px < 3.0; from_px += 0.17) {
            const auto lines = lines_of(pattern, {5, 9, from_px, from_px + 1.0});
            EXPECT_EQ(lines.size(), 4U * static_cast<std::size_t>(per_pixel)) << from_px;
        }
    }
}

// Of eight that follow each other one is in each eighth of the row's height, wherever the first is.
TEST(LinePattern, SuccessiveLinesAreStratifiedAcrossTheRow) {
    const LinePattern pattern = {kSize, DriftAxis::Y, 1};
    for (int column = 0; column < 20; ++column) {
        for (int first = -8; first < 40; ++first) {
            const auto lines = lines_of(pattern, {column, column + 1, static_cast<double>(first), first + 8.0});
            std::set<int> eighths;
            for (const DriftingLine& line : lines) eighths.insert(static_cast<int>(8.0 * line.across_px));
            EXPECT_EQ(lines.size(), 8U);
            EXPECT_EQ(eighths.size(), 8U) << first;
        }
    }
}

// Taken in parts, the pattern is the same lines.
TEST(LinePattern, PartsAreTheWhole) {
    const LinePattern pattern = {kSize, DriftAxis::X, 3};
    const auto key = [](const DriftingLine& l) { return std::tuple(l.row, l.home_px, l.across_px); };
    std::multiset<std::tuple<int, double, double>> whole, parts;
    for (const auto& l : lines_of(pattern, {0, 10, -4.0, 20.0})) whole.insert(key(l));
    for (const HomeRange& part :
         {HomeRange{0, 4, -4.0, 7.3}, {4, 10, -4.0, 7.3}, {0, 1, 7.3, 20.0}, {1, 10, 7.3, 20.0}}) {
        for (const auto& l : lines_of(pattern, part)) parts.insert(key(l));
    }
    EXPECT_EQ(whole, parts);
}

TEST(LinePattern, ASampleIsAtItsHomeInItsPixel) {
    const DriftingLine line = {7, 3.25, 0.5};
    const ImageSample along_x = sample_of({kSize, DriftAxis::X, 1}, line, 0.0);
    EXPECT_DOUBLE_EQ(along_x.x, kSize.film_x(3.25));
    EXPECT_DOUBLE_EQ(along_x.y, kSize.film_y(7.5));
    const ImageSample along_y = sample_of({kSize, DriftAxis::Y, 1}, line, 2.0);
    EXPECT_DOUBLE_EQ(along_y.x, kSize.film_x(7.5));
    EXPECT_DOUBLE_EQ(along_y.y, kSize.film_y(1.25));
}

}  // namespace
}  // namespace overfly
