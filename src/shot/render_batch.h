#pragma once

#include <exception>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/error.h"
#include "shot/render_shot.h"

namespace overfly {

// What became of one shot of a batch.
struct ShotOutcome {
    std::filesystem::path shot;
    std::optional<RenderResult> result;  // none: it failed
    std::vector<Problem> problems;       // why; of places without a file, the shot is meant
    bool our_fault = false;              // something that is not the user's to mend
};

// Renders shots one after another; one that fails does not keep the others from being rendered. One that would write
// over the frames of an earlier one fails.
// overrides: as for read_shot_document, for every shot. Throws Interrupted only.
[[nodiscard]] std::vector<ShotOutcome> render_batch(std::span<const std::filesystem::path> shots,
                                                    std::span<const std::string> overrides,
                                                    const RenderOptions& options);

}  // namespace overfly
