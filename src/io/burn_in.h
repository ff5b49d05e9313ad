#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "film/preview_style.h"
#include "io/display.h"

namespace overfly {

// The lines that are wanted over the picture of a frame, as the frame's own header says them:
//   42, 1.708 s
//   37.5771° N, 105.4857° W, 4371 m
// What the header does not say is left out. Throws UserError where the file is no OpenEXR file.
[[nodiscard]] std::vector<std::string> burn_in_lines(const BurnIn& wanted, const std::filesystem::path& frame);

// Writes lines into the lower left corner, the last one lowest; a dot of a letter is dot_px large, or less where a line
// would be wider than the picture.
void burn_in(DisplayImage& image, const std::vector<std::string>& lines, int dot_px);

}  // namespace overfly
