#pragma once

#include "io/display.h"

namespace overfly {

// Writes a number into a picture: white digits on black, with the lower left corner of the black box at (left, bottom).
// One dot of a digit is scale x scale pixels. Digits of our own need no font that may not be installed.
// What does not fit into the picture is left out.
void draw_number(DisplayImage& image, int number, int left, int bottom, int scale);

}  // namespace overfly
