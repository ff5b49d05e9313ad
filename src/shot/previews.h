#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "config/documents.h"
#include "core/progress.h"
#include "io/preview_look.h"
#include "shot/frame_plan.h"

namespace overfly {

struct Previews {
    std::filesystem::path contact_sheet, movie;  // empty where the shot wants none
};

[[nodiscard]] inline bool makes_previews(const ShotDocument& shot) {
    return shot.output.contact_sheet || shot.output.movie;
}

// How those of the shot look. Throws UserError where it asks for a view that can't be had.
[[nodiscard]] PreviewLook preview_look_of(const ShotDocument& shot);

// A contact sheet (NAME.contact.png) and a movie (NAME.mp4) of those frames of the shot that are on disk and were made
// from `inputs` (shot_inputs_hash). One that exists, is newer than all of them and was made with this look is kept
// unless `frames_changed`. Throws UserError.
[[nodiscard]] Previews make_previews(const ShotDocument& shot, const PreviewLook& look,
                                     std::span<const PlannedFrame> frames, const std::string& inputs,
                                     bool frames_changed, const Progress& progress);

}  // namespace overfly
