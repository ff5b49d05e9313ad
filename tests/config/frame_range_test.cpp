#include "config/frame_range.h"

#include <gtest/gtest.h>

#include <limits>

#include "config/sample_documents.h"

namespace overfly {
namespace {

using config_tests::error_text;
using Frames = std::vector<int>;

constexpr FrameSpan hundred{1, 100};

std::string refusal(const std::string& text, FrameSpan available = hundred) {
    return error_text([&] { (void)parse_frame_range(text, available); });
}

TEST(ParseFrameRange, ReadsNumbersRangesAndSteps) {
    EXPECT_EQ(parse_frame_range("5", hundred), (Frames{5}));
    EXPECT_EQ(parse_frame_range("10-13", hundred), (Frames{10, 11, 12, 13}));
    EXPECT_EQ(parse_frame_range("7-7", hundred), (Frames{7}));
    EXPECT_EQ(parse_frame_range("1-100:40", hundred), (Frames{1, 41, 81}));
    EXPECT_EQ(parse_frame_range("1-9x4", hundred), (Frames{1, 5, 9}));
    EXPECT_EQ(parse_frame_range("1,5,10-12", hundred), (Frames{1, 5, 10, 11, 12}));
    EXPECT_EQ(parse_frame_range("1-100", hundred).size(), 100U);
}

TEST(ParseFrameRange, SortsAndMergesWhatOverlaps) {
    EXPECT_EQ(parse_frame_range("12,10-13,1,12", hundred), (Frames{1, 10, 11, 12, 13}));
}

TEST(ParseFrameRange, SurvivesTheLargestNumbers) {
    constexpr int most = std::numeric_limits<int>::max();
    EXPECT_EQ(parse_frame_range("2147483647", {0, most}), (Frames{most}));
    EXPECT_EQ(parse_frame_range("1-2147483647:2147483646", {0, most}), (Frames{1, most}));
}

TEST(ParseFrameRange, RefusesWhatIsMalformed) {
    constexpr const char* allowed =
        "', allowed a frame (5), a range (10-20) or a range with a step (1-100:5 or 1-100x5), separated by commas";
    for (const std::string text : {"", "a", "-5", "5-", "1--5", "1-5:", "1-5:0", "1-5:-1", "1-5y2", "5:2", "1-5x2z",
                                   " 5", "99999999999", "1.5", "0x5"}) {
        EXPECT_EQ(refusal(text), "--frames " + text + ": got '" + text + allowed);
    }
}

TEST(ParseFrameRange, RefusesWhatIsEmptyOrOutside) {
    EXPECT_EQ(refusal("20-10"),
              "--frames 20-10: got 20-10, which is empty, allowed a first frame that is not after the last");
    EXPECT_EQ(refusal("90-101"), "--frames 90-101: got 90-101, allowed frames 1 to 100");
    EXPECT_EQ(refusal("0"), "--frames 0: got 0, allowed frames 1 to 100");
}

TEST(ParseFrameRange, SaysAllThatIsWrongAtOnce) {
    EXPECT_EQ(refusal("5,200,3-1"),
              "--frames 5,200,3-1: got 200, allowed frames 1 to 100\n"
              "--frames 5,200,3-1: got 3-1, which is empty, allowed a first frame that is not after the last");
}

}  // namespace
}  // namespace overfly
