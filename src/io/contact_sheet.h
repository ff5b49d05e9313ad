#pragma once

#include <filesystem>
#include <span>

#include "io/display.h"

namespace overfly {

struct NumberedFrame {
    int number = 1;
    std::filesystem::path file;
};

struct ContactSheetOptions {
    int columns = 4;
    int most_thumbnails = 16;
    int thumbnail_width_px = 320;
};

// A sequence at a glance: thumbnails in reading order, each with its frame number in its lower left corner. Of a longer
// sequence it shows as many as allowed, evenly spread, the first and the last among them.
// REQUIRES: frames is not empty; options are positive. Throws UserError where a frame can't be read.
[[nodiscard]] DisplayImage contact_sheet(std::span<const NumberedFrame> frames,
                                         const ContactSheetOptions& options = {});

// The same, as a PNG file.
void write_contact_sheet(const std::filesystem::path& file, std::span<const NumberedFrame> frames,
                         const ContactSheetOptions& options = {});

}  // namespace overfly
