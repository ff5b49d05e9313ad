#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"
#include "shot/frame_check.h"

namespace overfly {

struct VerifyOptions {
    std::string frames;  // a choice of frames (config/frame_range.h); empty: all
    Progress progress;
};

struct BadFrame {
    std::filesystem::path file;
    int number = 1;
    FrameFault fault = FrameFault::Missing;
    std::string message;
};

struct SequenceVerdict {
    std::string name;           // of its files: NAME.0001.exr
    bool has_manifest = false;  // else only what the files themselves tell was checked
    int frames = 0;             // how many there should be
    std::vector<BadFrame> bad;  // by number
    // Files on disk of frames and of layers that the sequence does not have, by the manifest.
    std::vector<std::filesystem::path> foreign;
};

// Checks every sequence in a folder: those of its manifest, and whatever else is called NAME.NUMBER.exr and is
// no file of a layer of such a sequence (io/layer_files.h). Of the latter the frames from the first to the last that is
// there are expected. Reads all frames. Throws UserError where the folder can't be read or has no frames, or where its
// manifest is none.
[[nodiscard]] std::vector<SequenceVerdict> verify_folder(const std::filesystem::path& folder,
                                                         const VerifyOptions& options);

}  // namespace overfly
