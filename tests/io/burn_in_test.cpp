#include "io/burn_in.h"

#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"
#include "io/picture_text.h"
#include "io/sample_frame.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const FrameHeader& header, const BurnIn& wanted) {
    const TemporaryFolder folder;
    write_frame(folder / "a.exr", sample_frame(8, 8), header);
    return burn_in_lines(wanted, folder / "a.exr");
}

constexpr BurnIn kAll = {.frame = true, .place = true, .time = true};

TEST(BurnIn, SaysWhatTheFramesHeaderSays) {
    EXPECT_EQ(lines_of(sample_header(), kAll), (Lines{"25, 1.000 s", "37.6000° N, 105.4000° W, 4500 m"}));
    FrameHeader header = sample_header();
    header.number = -3;
    header.time_s = -0.5;
    header.camera_place = {Angle::degrees(178.25), Angle::degrees(-41.00004), 20.0};
    header.camera_altitude_m = -12.4;
    EXPECT_EQ(lines_of(header, kAll), (Lines{"-3, -0.500 s", "41.0000° S, 178.2500° E, -12 m"}));
}

TEST(BurnIn, SaysNoMoreThanIsWanted) {
    EXPECT_EQ(lines_of(sample_header(), {}), Lines{});
    EXPECT_EQ(lines_of(sample_header(), {.frame = true}), Lines{"25"});
    EXPECT_EQ(lines_of(sample_header(), {.time = true}), Lines{"1.000 s"});
    EXPECT_EQ(lines_of(sample_header(), {.place = true}), Lines{"37.6000° N, 105.4000° W, 4500 m"});
}

TEST(BurnIn, RefusesWhatIsNoFrame) {
    const TemporaryFolder folder;
    std::ofstream(folder / "text.exr") << "not a picture";
    EXPECT_THROW(static_cast<void>(burn_in_lines(kAll, folder / "text.exr")), UserError);
}

TEST(BurnIn, StacksLinesInTheLowerLeftCorner) {
    DisplayImage drawn{.width = 80, .height = 40}, expected = drawn;
    drawn.rgb.assign(drawn.index(0, 40), 100);
    expected.rgb = drawn.rgb;
    burn_in(drawn, {"1", "25"}, 2);
    draw_text(expected, "25", 0, 40, 2);
    draw_text(expected, "1", 0, 40 - text_height_px(2), 2);
    EXPECT_EQ(drawn, expected);
}

TEST(BurnIn, MakesALongLineSmallerUntilItFits) {
    DisplayImage drawn{.width = 60, .height = 40}, expected = drawn;
    drawn.rgb.assign(drawn.index(0, 40), 100);
    expected.rgb = drawn.rgb;
    ASSERT_LE(text_width_px("1234567", 1), 60);
    ASSERT_GT(text_width_px("1234567", 2), 60);
    burn_in(drawn, {"1234567"}, 3);
    draw_text(expected, "1234567", 0, 40, 1);
    EXPECT_EQ(drawn, expected);
}

}  // namespace
}  // namespace overfly
