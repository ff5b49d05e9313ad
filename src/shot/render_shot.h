#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "config/documents.h"
#include "core/progress.h"
#include "shot/flight_scene.h"
#include "shot/interrupted.h"
#include "shot/previews.h"
#include "trace/visible_segment.h"

namespace overfly {

struct RenderOptions {
    std::string frames;  // a choice of frames (config/frame_range.h); empty: all
    std::filesystem::path cache_folder;
    Progress progress;
    // One line of news, such as what was found on disk.
    std::function<void(const std::string&)> say;
    ShouldStop should_stop;
    // Of so many lines that the kinetic tracer follows, one is asked again of a discrete ray, and those that differ are
    // counted (trace/kinetic_check.h); 0: none.
    std::uint64_t check_every = 0;
    bool repair = false;               // keep only what verify_folder finds sound (shot/frames_on_disk.h)
    std::vector<std::string> command;  // what the user typed, for the manifest
};

struct RenderResult {
    int frames_in_shot = 0;
    int frames_wanted = 0;
    int frames_rendered = 0;
    int frames_kept = 0;  // found complete and of these inputs
    std::filesystem::path folder;
    Previews previews;
    double prepare_s = 0.0, light_s = 0.0, trace_s = 0.0, preview_s = 0.0, total_s = 0.0;
    double write_s = 0.0;   // of all frames, one by one; most of it passes while others are traced, within trace_s
    FlightMeshReport mesh;  // all zeros where every frame was kept
    std::size_t motion_pieces = 0;
    double motion_error_px = 0.0;
    TraceCounters counters;
};

// From a shot document to frames, a contact sheet and a preview movie. A frame that is complete on disk and was made
// from the same inputs is kept; others are rendered. Frames appear under their names when they are complete. Throws
// UserError, and Interrupted when asked to stop; what was finished before stays. GUARANTEES: a frame is the same to the
// bit for any choice of frames, any number of threads, and whatever was on disk.
[[nodiscard]] RenderResult render_shot(const ShotDocument& shot, const RenderOptions& options);

}  // namespace overfly
