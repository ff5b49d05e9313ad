#pragma once

#include <cstddef>
#include <span>

#include "core/progress.h"
#include "flight/motion.h"
#include "shot/expose_piece.h"
#include "shot/frame_plan.h"
#include "shot/frame_writer.h"

namespace overfly {

// The fewest films that frames can stream through: one that is exposed, and one that is still open from the piece of
// the motion before, or that is being written.
inline constexpr std::size_t kFewestFilms = 2;

struct FrameLoop {
    const Exposing& exposing;
    const Motion& motion;
    std::span<const PlannedFrame> frames;  // in time order
    FrameWriter& writer;
    std::size_t films;  // at once, exposed or in hand of the writer; at least kFewestFilms
    const Progress& progress;
};

struct TracedFrames {
    double seconds = 0.0;
    TraceCounters counters;
};

// Renders the frames in the order of time, piece by piece of the flight: of those that are exposed in a piece windows
// of as many as there are films for, one after another. Each is handed to the writer when its shutter has closed, and
// written while the next window is traced.
// Throws what the writer has thrown, as soon as that is known, and Interrupted when asked to stop; what is complete
// then is listed. GUARANTEES: frames are the same to the bit for any number of films.
TracedFrames run_frames(const FrameLoop& loop);

// How many windows so many frames of a piece go by in, of about as many frames each. Half of the films are for those
// that are being written, but never more than two.
[[nodiscard]] std::size_t windows_of(std::size_t frames, std::size_t films);

// How many films there is work for: with two windows of all frames of a piece nobody waits.
[[nodiscard]] std::size_t most_films(const Motion& motion, std::span<const PlannedFrame> frames);

}  // namespace overfly
