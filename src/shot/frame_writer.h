#pragma once

#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>

#include "core/background_tasks.h"
#include "core/stopwatch.h"
#include "film/film_frame.h"
#include "film/frame_storage.h"
#include "io/frame_file.h"
#include "shot/frame_plan.h"
#include "shot/sequence_manifest.h"

namespace overfly {

// A frame while it is exposed, and until it is written.
struct FrameOnFilm {
    PlannedFrame frame;
    FilmFrame film;
    double render_s = 0.0;  // for the manifest
};

// And what is written of it.
struct FinishedFrame {
    Frame picture;
    FrameHeader header;
};

// Writes frames while others are traced, in the order in which they come, and lists them in the manifest, which is its
// own meanwhile. All but what is said of a frame's file being whole (io/frame_file.h) is for one thread to call.
// GUARANTEES: when a frame can't be written no later one is begun, and whoever asks next is told why.
class FrameWriter {
  public:
    // Called from several threads at once.
    using Finish = std::function<FinishedFrame(const PlannedFrame&, FilmFrame)>;
    // The manifest must outlive it.
    FrameWriter(Finish finish, const FrameStorage& storage, SequenceManifest& manifest);
    ~FrameWriter();  // discards
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    // Films that are not written yet count as in hand. Neither call throws what writing has thrown.
    void write(FrameOnFilm frame);
    [[nodiscard]] std::size_t in_hand() const;
    void wait();
    [[nodiscard]] bool has_failed() const;

    // Until all are written and listed. Throws what the first frame that failed has thrown, or the manifest: UserError.
    void finish();
    // Ends with the frames that are being written; the rest are gone. What is complete is listed. Throws as finish().
    void discard();

    [[nodiscard]] int frames_written() const;
    // What writing and listing took, frame by frame: not what a render waited for it.
    [[nodiscard]] double seconds() const;

  private:
    void write_next();
    void list(ManifestFrame frame);
    void save();
    void fail(std::exception_ptr error);

    Finish finish_frame_;
    FrameStorage storage_;
    SequenceManifest* manifest_;
    // Of what follows, all that tasks touch. One for the manifest, which others need not wait for while it is written.
    mutable std::mutex mutex_, manifest_mutex_;
    std::deque<FrameOnFilm> waiting_;
    std::size_t in_hand_ = 0;  // waiting, or being written
    int written_ = 0;
    double seconds_ = 0.0;
    Stopwatch since_saved_;
    std::exception_ptr error_;
    BackgroundTasks tasks_;  // the last, so that they have ended before what they touch goes
};

}  // namespace overfly
