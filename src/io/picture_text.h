#pragma once

#include <string_view>

#include "io/display.h"

namespace overfly {

// Text in a picture, from dots of our own: no font need be installed. It knows the digits, N S E W m s - . , : °, and
// the space. REQUIRES: nothing else is in a text; scale >= 1.

// In pixels, of one line with its margins. One dot of a letter is scale x scale pixels.
[[nodiscard]] int text_width_px(std::string_view text, int scale);
[[nodiscard]] int text_height_px(int scale);

// Writes white on black, with the lower left corner of the black box at (left, bottom). What does not fit into the
// picture is left out.
void draw_text(DisplayImage& image, std::string_view text, int left, int bottom, int scale);

}  // namespace overfly
