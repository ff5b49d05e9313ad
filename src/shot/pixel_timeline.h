#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/documents.h"
#include "core/progress.h"
#include "shot/frame_plan.h"
#include "shot/pixel_tile.h"
#include "shot/timeline.h"

namespace overfly {

// What is asked of a shot's pixel, as the command line says it.
struct PixelQuestion {
    std::string pixel;   // X,Y: column and row, from 0 at the upper left
    std::string frames;  // a choice of frames (config/frame_range.h), from the first's exposure to the last's
    std::string time;    // A-B, seconds of the flight. Without either: one motion piece in the middle of the shot
    std::optional<TriangleId> triangle;  // whose curve, of the first surface that has one in sight; none: those that
                                         // are seen longest
    std::filesystem::path cache_folder;
    Progress progress;
};

struct PixelTimeline {
    std::string shot;  // its name
    PictureSize picture;
    int x_px = 0, y_px = 0;
    std::vector<std::string> surfaces;  // their names: the terrain, then the bodies
    std::vector<PlannedFrame> frames;   // whose shutter is open at any of the time
    Timeline timeline;                  // of the pixel's centre
    std::vector<PlaneCurve> curves;     // of triangles that are seen, in the order of time; or of the one asked for
};

// Throws UserError where the question has no answer: no such pixel, frame or time.
[[nodiscard]] PixelTimeline pixel_timeline(const ShotDocument& shot, const PixelQuestion& question);

}  // namespace overfly
