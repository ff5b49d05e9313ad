#include "config/frame_rate.h"

#include <gtest/gtest.h>

namespace overfly::config {
namespace {

TEST(ParseFrameRate, ReadsWholeAndDecimalNumbers) {
    EXPECT_EQ(parse_frame_rate("24"), (FrameRate{24, 1}));
    EXPECT_EQ(parse_frame_rate("25.0"), (FrameRate{25, 1}));
    EXPECT_EQ(parse_frame_rate("12.5"), (FrameRate{25, 2}));
    EXPECT_EQ(parse_frame_rate("0.001"), (FrameRate{1, 1000}));
    EXPECT_EQ(parse_frame_rate("1000"), (FrameRate{1000, 1}));
    EXPECT_EQ(parse_frame_rate("16.667"), (FrameRate{16667, 1000}));
}

TEST(ParseFrameRate, KnowsTheNtscRates) {
    EXPECT_EQ(parse_frame_rate("23.976"), (FrameRate{24000, 1001}));
    EXPECT_EQ(parse_frame_rate("23.976024"), (FrameRate{24000, 1001}));
    EXPECT_EQ(parse_frame_rate("29.97"), (FrameRate{30000, 1001}));
    EXPECT_EQ(parse_frame_rate("47.952"), (FrameRate{48000, 1001}));
    EXPECT_EQ(parse_frame_rate("59.94"), (FrameRate{60000, 1001}));
    EXPECT_EQ(parse_frame_rate("119.88"), (FrameRate{120000, 1001}));
}

TEST(ParseFrameRate, ReadsRatiosInLowestTerms) {
    EXPECT_EQ(parse_frame_rate("24000/1001"), (FrameRate{24000, 1001}));
    EXPECT_EQ(parse_frame_rate("50/2"), (FrameRate{25, 1}));
    EXPECT_EQ(parse_frame_rate("1/1000000"), (FrameRate{1, 1'000'000}));
}

TEST(ParseFrameRate, RefusesAllElse) {
    for (const char* text : {"",         "film",   "0",       "-24",       "1001",
                             "1000.001", "0.0004", "23.1234", "nan",       "inf",
                             "24/",      "/1",     "24/0",    "0/1",       "-24/-1",
                             "24/1/1",   "24 / 1", "1001/1",  "1/1000001", "9999999999999999999/1"}) {
        EXPECT_EQ(parse_frame_rate(text), std::nullopt) << '"' << text << '"';
    }
}

}  // namespace
}  // namespace overfly::config
