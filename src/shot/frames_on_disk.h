#pragma once

#include <span>
#include <string>
#include <vector>

#include "config/documents.h"
#include "core/progress.h"
#include "shot/frame_plan.h"
#include "shot/sequence_manifest.h"

namespace overfly {

// What a run finds of the frames that it is to render.
struct FramesOnDisk {
    std::vector<PlannedFrame> to_render;  // missing, incomplete, or of other inputs; to be repaired
    int kept = 0;                         // the others
    std::vector<std::string> news;        // lines for the user
};

struct Resuming {
    const ShotDocument& shot;
    const std::string& inputs;  // shot_inputs_hash
    // Repairing: a frame is kept only if verify_folder would find nothing wrong with it, against the manifest as well.
    // Otherwise any frame is kept that can be read to its end and was made from these inputs.
    bool repairing = false;
    const Progress& progress;
};

// Reads all frames that are there. The manifest gets what it does not know of those that are kept, and forgets those
// that are to be rendered; it isn't saved.
[[nodiscard]] FramesOnDisk look_at_frames(std::span<const PlannedFrame> wanted, const Resuming& resuming,
                                          SequenceManifest& manifest);

}  // namespace overfly
