#pragma once

#include <filesystem>
#include <span>

#include "core/progress.h"
#include "flight/shutter.h"
#include "io/preview_look.h"

namespace overfly {

// A preview of a sequence for any player: H.264, 8 bits, in an MP4 file that appears when it is complete. Encoded by
// the program ffmpeg. Pictures look as `look` says.
// Those of odd width or height get their last column or row twice: the format wants even ones.
// REQUIRES: frames is not empty. Throws UserError: ffmpeg is not installed or fails, a frame can't be read or has
// another size than the first, the file can't be written.
void write_movie(const std::filesystem::path& file, std::span<const std::filesystem::path> frames, FrameRate rate,
                 const Progress& progress = {}, const PreviewLook& look = {});

}  // namespace overfly
