#include "shot/drift_stretches.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

constexpr double kDrift_px = 8.0;

// Half as long as frames last.
std::vector<TimeRange> exposures(int count, double frame_s) {
    std::vector<TimeRange> out;
    for (int k = 0; k < count; ++k) out.push_back({(k + 0.25) * frame_s, (k + 0.75) * frame_s});
    return out;
}

TEST(DriftStretches, AreThePieceWhereLinesDontDriftFar) {
    const TimeRange piece = {0.0, 8.0 / 24.0};
    EXPECT_EQ(drift_stretches(piece, exposures(8, 1.0 / 24.0), kDrift_px), std::vector{piece});
    EXPECT_EQ(drift_stretches({0.1, 0.11}, std::vector<TimeRange>{{0.0, 2.0}}, kDrift_px).size(), 1U);
}

// Ten times the frame rate: lines drift by 16 pixels a frame.
TEST(DriftStretches, CutALongPieceBetweenExposures) {
    const TimeRange piece = {0.0, 80.0 / 240.0};
    const std::vector<TimeRange> frames = exposures(80, 1.0 / 240.0);
    const std::vector<TimeRange> stretches = drift_stretches(piece, frames, kDrift_px);
    ASSERT_EQ(stretches.size(), 4U);
    EXPECT_EQ(stretches.front().begin_s, piece.begin_s);
    EXPECT_EQ(stretches.back().end_s, piece.end_s);
    for (std::size_t k = 0; k + 1 < stretches.size(); ++k) {
        EXPECT_EQ(stretches[k].end_s, stretches[k + 1].begin_s);
        EXPECT_NEAR(stretches[k].end_s, static_cast<double>(20 * (k + 1)) / 240.0, 1e-12);
    }
}

TEST(DriftStretches, AreNoneWhereEachExposureIsSweptByItself) {
    const TimeRange piece = {0.0, 4.0 / 24.0};
    std::vector<TimeRange> frames = exposures(4, 1.0 / 24.0);
    frames[2].end_s += 1e-3;
    EXPECT_TRUE(drift_stretches(piece, frames, kDrift_px).empty());
    const std::vector<TimeRange> instants = {{0.02, 0.02}, {0.1, 0.1}};
    EXPECT_TRUE(drift_stretches(piece, instants, kDrift_px).empty());
    // So short that lines would pass all of the picture from one to the next.
    const std::vector<TimeRange> short_ones = {{0.02, 0.0201}, {0.1, 0.1001}};
    EXPECT_TRUE(drift_stretches(piece, short_ones, kDrift_px).empty());
}

}  // namespace
}  // namespace overfly
