#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/progress.h"
#include "io/frame_digest.h"
#include "io/frame_facts.h"
#include "io/manifest_file.h"

namespace overfly {

enum class FrameFault {
    Missing,
    LayerMissing,  // the file of a layer, while the frame itself is there
    Truncated,     // cut off
    Unreadable,    // no OpenEXR, or damaged
    OtherInputs,   // rendered from something else than it should be
    Size,          // not as many pixels as it should have
    Misplaced,     // its header says that it is another frame
    Pixels,        // they are not those that the manifest lists
    NotFinite,     // a value is infinite or no number
    Black,         // or transparent throughout
    Duplicate,     // the pixels of another frame, though the camera has moved
    Unlisted,      // the manifest does not know it, though it is there
};

// "missing", "unreadable" ...: for programs
[[nodiscard]] const char* name_of(FrameFault fault);

// A frame, and what is known of it without looking at it. Which of its layers have files of their own, it says itself:
// what is wrong with one of those is wrong with the frame.
struct FrameExpectation {
    int number = 1;
    std::filesystem::path file;
    std::optional<ManifestFrame> listed;  // what the manifest says of it
    std::string inputs;                   // empty: not known
    int width = 0, height = 0;            // 0: not known
};

struct CheckedFrame {
    std::optional<FrameFault> fault;    // the first of FrameFault's order
    std::string message;                // what is wrong with it, without its name
    std::optional<FrameDigest> digest;  // of one that can be read
    FrameFacts facts;
};

// Reads every frame whole, several at once, and says what is wrong with each of them; nothing of those that are sound.
// Whether a frame should be listed is left to the caller.
[[nodiscard]] std::vector<CheckedFrame> check_frames(std::span<const FrameExpectation> expected,
                                                     const Progress& progress);

}  // namespace overfly
