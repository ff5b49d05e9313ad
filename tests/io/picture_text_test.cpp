#include "io/picture_text.h"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.h"

namespace overfly {
namespace {

DisplayImage grey(int width, int height) {
    DisplayImage image{.width = width, .height = height};
    image.rgb.assign(image.index(0, height), 100);
    return image;
}

// Row by row: '#' white, ' ' black, '.' untouched.
std::vector<std::string> picture(const DisplayImage& image) {
    std::vector<std::string> rows;
    for (int y = 0; y < image.height; ++y) {
        std::string& row = rows.emplace_back();
        for (int x = 0; x < image.width; ++x) {
            const int level = image.rgb[image.index(x, y)];
            row += level == 255 ? '#' : level == 0 ? ' ' : '.';
        }
    }
    return rows;
}

TEST(PictureText, StandsInABlackBoxInItsCorner) {
    DisplayImage image = grey(20, 10);
    draw_text(image, "-4.", 1, 10, 1);
    EXPECT_EQ(picture(image), (std::vector<std::string>{
                                  "....................",
                                  ".               ....",
                                  ".         #     ....",
                                  ".        ##     ....",
                                  ".       # #     ....",
                                  ". #### #  #     ....",
                                  ".      #####    ....",
                                  ".         #  ## ....",
                                  ".         #  ## ....",
                                  ".               ....",
                              }));
    EXPECT_EQ(text_width_px("-4.", 1), 15);
    EXPECT_EQ(text_height_px(1), 9);
}

TEST(PictureText, GrowsByScale) {
    DisplayImage small = grey(7, 9), large = grey(21, 27);
    draw_text(small, "8", 0, 9, 1);
    draw_text(large, "8", 0, 27, 3);
    EXPECT_EQ(text_width_px("8", 3), 21);
    EXPECT_EQ(text_height_px(3), 27);
    for (int y = 0; y < 27; ++y) {
        for (int x = 0; x < 21; ++x) {
            EXPECT_EQ(large.rgb[large.index(x, y)], small.rgb[small.index(x / 3, y / 3)]) << x << ' ' << y;
        }
    }
}

TEST(PictureText, IsCutAtThePicturesEdge) {
    DisplayImage image = grey(6, 4);
    draw_text(image, "1234567", -2, 6, 2);
    EXPECT_EQ(image.rgb.size(), 6U * 4U * 3U);
}

// Each of them looks like itself alone: what a 5 and an S, or a minus and a space, must not share.
TEST(PictureText, HasADifferentPictureForEachLetter) {
    std::set<std::vector<std::string>> pictures;
    const std::vector<std::string> letters = {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9", "-",
                                              ".", ",", ":", "°", "N", "S", "E", "W", "m", "s", " "};
    for (const std::string& letter : letters) {
        DisplayImage image = grey(7, 9);
        draw_text(image, letter, 0, 9, 1);
        pictures.insert(picture(image));
    }
    EXPECT_EQ(pictures.size(), letters.size());
}

TEST(PictureText, DigitsAreEquallyWide) {
    for (const char* digit : {"0", "1", "2", "3", "4", "5", "6", "7", "8", "9"}) EXPECT_EQ(text_width_px(digit, 1), 7);
}

TEST(PictureText, RefusesALetterWithoutDots) {
    DisplayImage image = grey(20, 10);
    EXPECT_THROW(draw_text(image, "4 km", 0, 10, 1), InternalError);
}

}  // namespace
}  // namespace overfly
