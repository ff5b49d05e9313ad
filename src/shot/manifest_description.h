#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/documents.h"
#include "io/manifest_file.h"
#include "shot/frame_plan.h"
#include "shot/input_files.h"
#include "shot/prepare_scene.h"

namespace overfly {

// What a manifest's text about a shot is made from.
struct ManifestSubjects {
    const ShotDocument& shot;
    const PreparedTerrain& terrain;
    std::span<const PlannedFrame> frames;  // all of the shot
    std::span<const InputFile> files;      // input_files
    std::span<const std::string> command;
    std::optional<double> mesh_error_px, motion_error_px;  // the largest that were found
};

// All that the manifest says of a shot's sequence but the hash of its inputs and its frames.
[[nodiscard]] ManifestSequence describe_sequence(const ManifestSubjects& subjects);

}  // namespace overfly
