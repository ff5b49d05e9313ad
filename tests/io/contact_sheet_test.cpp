#include "io/contact_sheet.h"

#include <string>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "io/frame_file.h"
#include "io/sample_frame.h"
#include "io/temporary_folder.h"

namespace overfly {
namespace {

// Frames of one colour each, brighter and brighter: 1/count, 2/count ...
std::vector<std::filesystem::path> grey_sequence(const TemporaryFolder& folder, int count) {
    std::vector<std::filesystem::path> frames;
    for (int number = 1; number <= count; ++number) {
        Frame frame = sample_frame(32, 18);
        const float level = 0.7F * static_cast<float>(number) / static_cast<float>(count);
        for (auto& rgba : frame.rgba) rgba = {level, level, level, 1.0F};
        frames.push_back(folder / ("f." + std::to_string(number) + ".exr"));
        write_frame(frames.back(), frame, sample_header());
    }
    return frames;
}

// Levels in the upper middle of each thumbnail, away from the number.
std::vector<int> levels(const DisplayImage& sheet, int columns, int rows, int width, int height) {
    std::vector<int> found;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int x = 4 + column * (width + 4) + width / 2, y = 4 + row * (height + 4) + height / 4;
            found.push_back(sheet.rgb[sheet.index(x, y)]);
        }
    }
    return found;
}

TEST(ContactSheet, ShowsFramesInReadingOrder) {
    const TemporaryFolder folder;
    const auto frames = grey_sequence(folder, 6);
    const DisplayImage sheet = contact_sheet(frames, {.columns = 3, .most_thumbnails = 6, .thumbnail_width_px = 64});
    EXPECT_EQ(sheet.width, 3 * 68 + 4);
    EXPECT_EQ(sheet.height, 2 * 40 + 4);
    std::vector<int> expected;
    for (const auto& frame : frames) expected.push_back(display_image(read_frame(frame)).rgb.front());
    EXPECT_EQ(levels(sheet, 3, 2, 64, 36), expected);
    EXPECT_LT(expected.front(), expected.back());
}

TEST(ContactSheet, SpreadsALongSequenceFromTheFirstToTheLast) {
    const TemporaryFolder folder;
    const auto frames = grey_sequence(folder, 11);
    const DisplayImage sheet = contact_sheet(frames, {.columns = 3, .most_thumbnails = 3, .thumbnail_width_px = 32});
    const auto level = [&](std::size_t i) { return int{display_image(read_frame(frames[i])).rgb.front()}; };
    EXPECT_EQ(levels(sheet, 3, 1, 32, 18), (std::vector<int>{level(0), level(5), level(10)}));
}

TEST(ContactSheet, IsAsWideAsAShortSequence) {
    const TemporaryFolder folder;
    const auto frames = grey_sequence(folder, 1);
    EXPECT_EQ(contact_sheet(frames, {.thumbnail_width_px = 32}).width, 32 + 8);
}

TEST(ContactSheet, NamesAFrameThatCannotBeRead) {
    const TemporaryFolder folder;
    auto frames = grey_sequence(folder, 2);
    frames[1] = folder / "missing.exr";
    try {
        static_cast<void>(contact_sheet(frames));
        FAIL() << "no error";
    } catch (const UserError& e) {
        EXPECT_EQ(std::string(e.what()), (folder / "missing.exr").string() + ": no such frame");
    }
}

TEST(ContactSheet, IsWrittenAsPng) {
    const TemporaryFolder folder;
    const auto frames = grey_sequence(folder, 2);
    write_contact_sheet(folder / "sheet.png", frames, {.thumbnail_width_px = 32});
    const DisplayImage sheet = contact_sheet(frames, {.thumbnail_width_px = 32});
    const auto input = OIIO::ImageInput::open((folder / "sheet.png").string());
    ASSERT_TRUE(input);
    ASSERT_EQ(input->spec().width, sheet.width);
    ASSERT_EQ(input->spec().height, sheet.height);
    ASSERT_EQ(input->spec().nchannels, 3);
    std::vector<std::uint8_t> pixels(sheet.rgb.size());
    ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, pixels.data()));
    EXPECT_EQ(pixels, sheet.rgb);
    EXPECT_THROW(write_contact_sheet(folder / "missing/sheet.png", frames), UserError);
}

}  // namespace
}  // namespace overfly
