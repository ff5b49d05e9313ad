#include "io/picture_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.h"

namespace overfly {
namespace {

constexpr int kRows = 7;  // in dots; one empty dot lies between and around letters

struct Glyph {
    std::string_view letter;  // UTF-8
    std::array<std::string_view, kRows> rows;

    [[nodiscard]] int width() const { return static_cast<int>(rows[0].size()); }
};

// '#' is a dot that is set. Digits are equally wide, so that numbers stand still while they count.
constexpr std::array kGlyphs = {
    Glyph{"0", {" ### ", "#   #", "#  ##", "# # #", "##  #", "#   #", " ### "}},
    Glyph{"1", {"  #  ", " ##  ", "  #  ", "  #  ", "  #  ", "  #  ", " ### "}},
    Glyph{"2", {" ### ", "#   #", "    #", "  ## ", " #   ", "#    ", "#####"}},
    Glyph{"3", {" ### ", "#   #", "    #", "  ## ", "    #", "#   #", " ### "}},
    Glyph{"4", {"   # ", "  ## ", " # # ", "#  # ", "#####", "   # ", "   # "}},
    Glyph{"5", {"#####", "#    ", "#### ", "    #", "    #", "#   #", " ### "}},
    Glyph{"6", {" ### ", "#    ", "#### ", "#   #", "#   #", "#   #", " ### "}},
    Glyph{"7", {"#####", "    #", "   # ", "   # ", "  #  ", "  #  ", "  #  "}},
    Glyph{"8", {" ### ", "#   #", "#   #", " ### ", "#   #", "#   #", " ### "}},
    Glyph{"9", {" ### ", "#   #", "#   #", " ####", "    #", "    #", " ### "}},
    Glyph{"-", {"    ", "    ", "    ", "####", "    ", "    ", "    "}},
    Glyph{".", {"  ", "  ", "  ", "  ", "  ", "##", "##"}},
    Glyph{",", {"  ", "  ", "  ", "  ", "##", " #", "# "}},
    Glyph{":", {"  ", "##", "##", "  ", "##", "##", "  "}},
    Glyph{"°", {" # ", "# #", " # ", "   ", "   ", "   ", "   "}},
    Glyph{"N", {"#   #", "##  #", "##  #", "# # #", "#  ##", "#  ##", "#   #"}},
    Glyph{"S", {" ####", "#    ", "#    ", " ### ", "    #", "    #", "#### "}},
    Glyph{"E", {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"}},
    Glyph{"W", {"#   #", "#   #", "#   #", "# # #", "# # #", "## ##", "#   #"}},
    Glyph{"m", {"     ", "     ", "## # ", "# # #", "# # #", "# # #", "# # #"}},
    Glyph{"s", {"    ", "    ", " ###", "#   ", " ## ", "   #", "### "}},
    Glyph{" ", {"  ", "  ", "  ", "  ", "  ", "  ", "  "}},
};

std::vector<const Glyph*> glyphs_of(std::string_view text) {
    std::vector<const Glyph*> glyphs;
    while (!text.empty()) {
        const auto* const glyph =
            std::ranges::find_if(kGlyphs, [&](const Glyph& g) { return text.starts_with(g.letter); });
        check(glyph != kGlyphs.end(), "a text in a picture has letters that there are dots for");
        glyphs.push_back(glyph);
        text.remove_prefix(glyph->letter.size());
    }
    return glyphs;
}

// The rows of a line of text with its margins, a character a dot.
std::vector<std::string> dots_of(std::string_view text) {
    std::vector<std::string> dots(kRows + 2, " ");
    for (const Glyph* glyph : glyphs_of(text)) {
        for (std::size_t row = 0; row < dots.size(); ++row) {
            const bool margin = row == 0 || row + 1 == dots.size();
            dots[row] += margin ? std::string(glyph->rows[0].size(), ' ') : std::string(glyph->rows[row - 1]);
            dots[row] += ' ';
        }
    }
    return dots;
}

// Sets the square of a dot; x and y are its upper left pixel.
void fill_dot(DisplayImage& image, int x, int y, int scale, std::uint8_t level) {
    for (int row = std::max(y, 0); row < std::min(y + scale, image.height); ++row) {
        for (int column = std::max(x, 0); column < std::min(x + scale, image.width); ++column) {
            std::fill_n(image.rgb.begin() + static_cast<std::ptrdiff_t>(image.index(column, row)), 3, level);
        }
    }
}

}  // namespace

int text_width_px(std::string_view text, int scale) {
    int dots = 1;
    for (const Glyph* glyph : glyphs_of(text)) dots += glyph->width() + 1;
    return scale * dots;
}

int text_height_px(int scale) { return scale * (kRows + 2); }

void draw_text(DisplayImage& image, std::string_view text, int left, int bottom, int scale) {
    constexpr std::uint8_t kBlack = 0, kWhite = 255;
    const std::vector<std::string> dots = dots_of(text);
    const int top = bottom - text_height_px(scale);
    for (int row = 0; row < static_cast<int>(dots.size()); ++row) {
        const std::string& line = dots[static_cast<std::size_t>(row)];
        for (int column = 0; column < static_cast<int>(line.size()); ++column) {
            const bool set = line[static_cast<std::size_t>(column)] == '#';
            fill_dot(image, left + column * scale, top + row * scale, scale, set ? kWhite : kBlack);
        }
    }
}

}  // namespace overfly
