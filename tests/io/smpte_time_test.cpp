#include "io/smpte_time.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

TEST(SmpteTime, CountsFramesSecondsMinutesHours) {
    constexpr FrameRate kFilm{24, 1};
    EXPECT_EQ(smpte_time(0, kFilm), (SmpteTime{0, 0, 0, 0}));
    EXPECT_EQ(smpte_time(23, kFilm), (SmpteTime{0, 0, 0, 23}));
    EXPECT_EQ(smpte_time(24, kFilm), (SmpteTime{0, 0, 1, 0}));
    EXPECT_EQ(smpte_time(24 * 3661 + 5, kFilm), (SmpteTime{1, 1, 1, 5}));
}

TEST(SmpteTime, WrapsAfterADayInBothDirections) {
    constexpr FrameRate kVideo{25, 1};
    EXPECT_EQ(smpte_time(25 * 86400, kVideo), (SmpteTime{0, 0, 0, 0}));
    EXPECT_EQ(smpte_time(-1, kVideo), (SmpteTime{23, 59, 59, 24}));
}

TEST(SmpteTime, CountsARateOf1000By1001AsTheWholeRate) {
    EXPECT_EQ(smpte_time(30, (FrameRate{30000, 1001})), (SmpteTime{0, 0, 1, 0}));
    EXPECT_EQ(smpte_time(23, (FrameRate{24000, 1001})), (SmpteTime{0, 0, 0, 23}));
}

TEST(SmpteTime, CountsPairsAbove30PerSecond) {
    EXPECT_EQ(smpte_time(59, (FrameRate{60, 1})), (SmpteTime{0, 0, 0, 29, true}));
    EXPECT_EQ(smpte_time(48, (FrameRate{50, 1})), (SmpteTime{0, 0, 0, 24, false}));
    EXPECT_EQ(smpte_time(61, (FrameRate{60000, 1001})), (SmpteTime{0, 0, 1, 0, true}));
}

TEST(SmpteTime, HasNoAnswerForOtherRates) {
    EXPECT_FALSE(smpte_time(1, (FrameRate{25, 2})));
    EXPECT_FALSE(smpte_time(1, (FrameRate{120, 1})));
    EXPECT_FALSE(smpte_time(1, (FrameRate{1, 10})));
}

}  // namespace
}  // namespace overfly
