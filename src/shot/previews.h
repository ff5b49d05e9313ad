#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "config/documents.h"
#include "core/progress.h"
#include "shot/frame_plan.h"

namespace overfly {

struct Previews {
    std::filesystem::path contact_sheet, movie;  // empty where the shot wants none
};

// A contact sheet (NAME.contact.png) and a movie (NAME.mp4) of those frames of the shot that are on disk and were made
// from `inputs` (shot_inputs_hash). One that exists and is newer than all of them is kept unless `frames_changed`.
// Throws UserError.
[[nodiscard]] Previews make_previews(const ShotDocument& shot, std::span<const PlannedFrame> frames,
                                     const std::string& inputs, bool frames_changed, const Progress& progress);

}  // namespace overfly
