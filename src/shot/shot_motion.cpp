#include "shot/shot_motion.h"

#include <algorithm>
#include <vector>

namespace overfly {
namespace {

// Long pieces spread what they take to prepare over many frames, short ones sweep less ground. So many frames that ten
// times a usual frame rate, or slow motion of it, cuts no more pieces; however many they are, they go by in windows of
// as many as there is memory for (frame_loop.h).
constexpr double kLongestPiece_s = 1.0 / 3.0;
constexpr double kLongestPiece_frames = 1024.0;

// Between two exposures that follow each other.
double gap_s(const PlannedFrame& frame, const PlannedFrame& next) {
    return 0.5 * (frame.exposure.end_s + next.exposure.begin_s);
}

// Where frames don't last equally long: pieces of as many as may be, cut between exposures.
std::vector<double> cuts_between(std::span<const PlannedFrame> frames) {
    std::vector<double> cuts_s;
    std::size_t begin = 0;
    for (std::size_t k = 0; k + 1 < frames.size(); ++k) {
        const double longer_s = frames[k + 1].time_s + frames[k + 1].lasts_s - frames[begin].time_s;
        if (longer_s <= kLongestPiece_s && static_cast<double>(k + 2 - begin) <= kLongestPiece_frames) continue;
        cuts_s.push_back(gap_s(frames[k], frames[k + 1]));
        begin = k + 1;
    }
    return cuts_s;
}

}  // namespace

MotionOptions motion_options(const ShotDocument& shot) {
    MotionOptions options;
    options.bound_px = shot.motion_bound_px;
    options.width_px = shot.image.width;
    options.height_px = shot.image.height;
    const std::vector<FlightSpeed>& speeds = shot.frames.speeds;
    const double speed = speeds.size() == 1 ? speeds.front().speed : 1.0;
    options.longest_piece_s = std::min(kLongestPiece_s, kLongestPiece_frames * speed / shot.frames.rate.per_s());
    return options;
}

Motion shot_motion(const ShotDocument& shot, const CameraPath& path, std::span<const PlannedFrame> frames,
                   const Stage& stage) {
    // Pieces exclude their end, and an exposure may be an instant.
    TimeRange when = exposed_times(frames);
    when.end_s =
        std::max(when.end_s, when.begin_s + frames.back().time_s + frames.back().lasts_s - frames.front().time_s);
    MotionOptions options = motion_options(shot);
    if (shot.frames.speeds.size() < 2) {
        const PlannedFrame& first = frames.front();
        options.gaps = {first.exposure.end_s + 0.5 * (first.lasts_s - first.exposure.duration_s()), first.lasts_s};
    } else {
        options.longest_piece_s = kLongestPiece_s;
        options.cuts_s = cuts_between(frames);
    }
    return fit_motion(path, when, stage.surroundings(), options);
}

}  // namespace overfly
