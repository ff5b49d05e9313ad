#pragma once

#include <span>
#include <string>

#include "config/documents.h"
#include "flight/camera_path.h"
#include "io/frame_file.h"
#include "shot/frame_plan.h"
#include "shot/input_files.h"
#include "shot/stage.h"

namespace overfly {

// Makes the headers of a shot's frames. Refers to the shot, the stage and the path.
class FrameHeaders {
  public:
    // inputs: shot_inputs_hash; files: input_files.
    FrameHeaders(const ShotDocument& shot, const Stage& stage, const CameraPath& path, std::string inputs,
                 std::span<const InputFile> files, std::span<const std::string> objects);

    [[nodiscard]] FrameHeader of(const PlannedFrame& frame) const;

  private:
    const ShotDocument* shot_;
    const Stage* stage_;
    const CameraPath* path_;
    FrameHeader common_;  // what all frames of the shot say
};

}  // namespace overfly
