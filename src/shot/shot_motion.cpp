#include "shot/shot_motion.h"

#include <algorithm>

namespace overfly {
namespace {

// A piece is traced in one go. Long ones spread the cost of setting lines down over many frames, also of a high frame
// rate; short ones sweep less ground and keep fewer frames open.
constexpr double kLongestPiece_s = 1.0 / 3.0;
constexpr double kLongestPiece_frames = 16.0;

}  // namespace

MotionOptions motion_options(const ShotDocument& shot) {
    MotionOptions options;
    options.bound_px = shot.motion_bound_px;
    options.width_px = shot.image.width;
    options.height_px = shot.image.height;
    options.longest_piece_s = std::min(kLongestPiece_s, kLongestPiece_frames / shot.frames.rate.per_s());
    return options;
}

Motion shot_motion(const ShotDocument& shot, const CameraPath& path, std::span<const PlannedFrame> frames,
                   const Stage& stage) {
    const double frame_s = 1.0 / shot.frames.rate.per_s();
    TimeRange when = exposed_times(frames);
    // Pieces exclude their end, and an exposure may be an instant.
    if (when.duration_s() < frame_s * static_cast<double>(frames.size()))
        when.end_s = when.begin_s + frame_s * static_cast<double>(frames.size());
    MotionOptions options = motion_options(shot);
    const TimeRange exposure = frames.front().exposure;
    options.gaps = {exposure.end_s + 0.5 * (frame_s - exposure.duration_s()), frame_s};
    return fit_motion(path, when, stage.surroundings(), options);
}

}  // namespace overfly
