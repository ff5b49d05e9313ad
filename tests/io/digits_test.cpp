#include "io/digits.h"

#include <string>

#include <gtest/gtest.h>

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

TEST(Digits, StandInABlackBoxInTheirCorner) {
    DisplayImage image = grey(15, 8);
    draw_number(image, -47, 1, 8, 1);
    EXPECT_EQ(picture(image), (std::vector<std::string>{
                                  "...............",
                                  ".             .",
                                  ".     # # ### .",
                                  ".     # #   # .",
                                  ". ### ###   # .",
                                  ".       #  #  .",
                                  ".       #  #  .",
                                  ".             .",
                              }));
}

TEST(Digits, GrowByScale) {
    DisplayImage small = grey(5, 7), large = grey(15, 21);
    draw_number(small, 8, 0, 7, 1);
    draw_number(large, 8, 0, 21, 3);
    for (int y = 0; y < 21; ++y) {
        for (int x = 0; x < 15; ++x) {
            EXPECT_EQ(large.rgb[large.index(x, y)], small.rgb[small.index(x / 3, y / 3)]) << x << ' ' << y;
        }
    }
}

TEST(Digits, AreCutAtThePicturesEdge) {
    DisplayImage image = grey(6, 4);
    draw_number(image, 1234567, -2, 6, 2);
    EXPECT_EQ(image.rgb.size(), 6U * 4U * 3U);
}

}  // namespace
}  // namespace overfly
