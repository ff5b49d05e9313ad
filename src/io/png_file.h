#pragma once

#include <filesystem>
#include <string>

#include "io/display.h"

namespace overfly {

// Writes a PNG file in one step, as frames are written (output_file.h), with `remark` as its description. Throws
// UserError.
void write_png(const std::filesystem::path& file, const DisplayImage& image, const std::string& remark = {});

}  // namespace overfly
