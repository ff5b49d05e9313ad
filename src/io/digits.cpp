#include "io/digits.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace overfly {
namespace {

constexpr int kDigitWidth = 3, kDigitHeight = 5;  // in dots; one empty dot lies between and around digits

// Row by row, '#' is a dot that is set.
constexpr std::array<std::string_view, 11> kGlyphs{
    "####.##.##.####",  // 0
    ".#.##..#..#.###",  // 1
    "###..#####..###",  // 2
    "###..#.##..####",  // 3
    "#.##.####..#..#",  // 4
    "####..###..####",  // 5
    "####..####.####",  // 6
    "###..#..#.#..#.",  // 7
    "####.#####.####",  // 8
    "####.####..####",  // 9
    "......###......",  // minus
};

std::string_view glyph(char c) { return kGlyphs[c == '-' ? 10U : static_cast<std::size_t>(c - '0')]; }

// Sets the square of a dot; x and y are its upper left pixel.
void fill_dot(DisplayImage& image, int x, int y, int scale, std::uint8_t level) {
    for (int row = std::max(y, 0); row < std::min(y + scale, image.height); ++row) {
        for (int column = std::max(x, 0); column < std::min(x + scale, image.width); ++column) {
            std::fill_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(image.index(column, row)), 3, level);
        }
    }
}

}  // namespace

void draw_number(DisplayImage& image, int number, int left, int bottom, int scale) {
    constexpr std::uint8_t kBlack = 0, kWhite = 255;
    const std::string text = std::to_string(number);
    const int columns = static_cast<int>(text.size()) * (kDigitWidth + 1) + 1;
    const int rows = kDigitHeight + 2;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            // Column 0 of each cell of four is the gap before a digit.
            const auto cell = static_cast<std::size_t>(column / (kDigitWidth + 1));
            const int within = column % (kDigitWidth + 1) - 1, dot_row = row - 1;
            const bool on_digit = within >= 0 && dot_row >= 0 && dot_row < kDigitHeight;
            const int dot = dot_row * kDigitWidth + within;
            const bool set = on_digit && glyph(text[cell])[static_cast<std::size_t>(dot)] == '#';
            fill_dot(image, left + column * scale, bottom - (rows - row) * scale, scale, set ? kWhite : kBlack);
        }
    }
}

}  // namespace overfly
