#pragma once

#include <filesystem>
#include <span>

#include "io/display.h"
#include "io/preview_look.h"

namespace overfly {

struct ContactSheetOptions {
    int columns = 4;
    int most_thumbnails = 16;
    int thumbnail_width_px = 320;
    PreviewLook look = {};
};

// A sequence at a glance: thumbnails in reading order, each with its frame number in its lower left corner and
// what else the look wants to be burnt in. Of a longer sequence it shows as many as allowed, evenly spread, the first
// and the last among them. REQUIRES: frames is not empty; options are positive. Throws UserError where a frame can't be
// read.
[[nodiscard]] DisplayImage contact_sheet(std::span<const std::filesystem::path> frames,
                                         const ContactSheetOptions& options = {});

// The same, as a PNG file.
void write_contact_sheet(const std::filesystem::path& file, std::span<const std::filesystem::path> frames,
                         const ContactSheetOptions& options = {});

}  // namespace overfly
