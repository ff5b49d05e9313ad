#pragma once

#include <filesystem>

#include "io/display.h"

namespace overfly {

// Writes a PNG file in one step, as frames are written (output_file.h). Throws UserError.
void write_png(const std::filesystem::path& file, const DisplayImage& image);

}  // namespace overfly
