#include "shot/frame_loop.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/stopwatch.h"

namespace overfly {
namespace {

class Loop {
  public:
    explicit Loop(const FrameLoop& asked)
        : loop_(&asked), exposing_(asked.exposing), total_(static_cast<double>(asked.frames.size())) {
        check(asked.films >= kFewestFilms, "there are films enough for frames to stream through");
        exposing_.should_stop = [this] {
            return loop_->writer.has_failed() || (loop_->exposing.should_stop && loop_->exposing.should_stop());
        };
    }

    TracedFrames run() {
        try {
            trace();
        } catch (const Interrupted&) {
            loop_->writer.discard();  // which throws where it is the writer that stopped us
            throw;
        }
        loop_->writer.finish();
        return result_;
    }

  private:
    using Window = std::vector<FrameOnFilm>;

    void trace() {
        std::size_t next = 0;  // the first frame whose shutter has not opened yet
        for (const MotionPiece& piece : loop_->motion.pieces) {
            std::size_t end = next;
            while (end < loop_->frames.size() && is_exposed_in(loop_->frames[end], piece)) ++end;
            if (end > next || !still_open_.empty()) trace(piece, loop_->frames.subspan(next, end - next));
            next = end;
        }
        check(still_open_.empty() && next == loop_->frames.size(), "every frame's exposure lies within the motion");
    }

    // opening: the frames whose shutters open in the piece.
    void trace(const MotionPiece& piece, std::span<const PlannedFrame> opening) {
        const Stopwatch watch;
        PieceExposure exposure(exposing_, piece);
        const double prepare_s = watch.seconds();
        Window before = std::exchange(still_open_, {});
        const std::size_t count = before.size() + opening.size();
        const std::size_t windows = windows_of(count, loop_->films);
        for (std::size_t k = 0, i = 0; k < windows; ++k) {
            Window window;
            for (; i < count * (k + 1) / windows; ++i) {
                window.push_back(i < before.size() ? std::move(before[i]) : opened(opening[i - before.size()]));
            }
            const double share = static_cast<double>(window.size()) / static_cast<double>(count);
            expose(exposure, piece, window, share * prepare_s);
            hand_over(std::move(window), piece.when.end_s);
        }
    }

    FrameOnFilm opened(const PlannedFrame& frame) {
        while (films_open_ + loop_->writer.in_hand() >= loop_->films) loop_->writer.wait();
        ++films_open_;
        return {frame, exposing_.film(frame)};
    }

    // prepare_s: what had to be done before, of which these frames have their share.
    void expose(PieceExposure& exposure, const MotionPiece& piece, Window& window, double prepare_s) {
        const Stopwatch watch;
        std::vector<PlannedFrame> frames;
        std::vector<FilmFrame*> films;
        for (FrameOnFilm& open : window) {
            frames.push_back(open.frame);
            films.push_back(&open.film);
        }
        const auto closing = static_cast<double>(
            std::ranges::count_if(frames, [&](const PlannedFrame& f) { return f.exposure.end_s <= piece.when.end_s; }));
        const auto progress = [&](double share) {
            if (loop_->progress) loop_->progress("rendering", closed_ + share * closing, total_);
        };
        exposure.expose(frames, films, result_.counters, progress);
        closed_ += closing;
        const double seconds = prepare_s + watch.seconds();
        result_.seconds += seconds;
        share_out(seconds, piece.when, window);
    }

    // Among the frames, by how long they were exposed in the piece; equally for instants.
    static void share_out(double seconds, TimeRange piece, Window& window) {
        const auto exposed_s = [&](const FrameOnFilm& open) {
            return std::max(0.0, intersection(open.frame.exposure, piece).duration_s());
        };
        double all_s = 0.0;
        for (const FrameOnFilm& open : window) all_s += exposed_s(open);
        for (FrameOnFilm& open : window) {
            const double share = all_s > 0.0 ? exposed_s(open) / all_s : 1.0 / static_cast<double>(window.size());
            open.render_s += share * seconds;
        }
    }

    void hand_over(Window window, double closed_until_s) {
        for (FrameOnFilm& open : window) {
            if (open.frame.exposure.end_s > closed_until_s) {
                still_open_.push_back(std::move(open));
                continue;
            }
            loop_->writer.write(std::move(open));
            --films_open_;
        }
    }

    const FrameLoop* loop_;
    Exposing exposing_;
    Window still_open_;  // from the piece before
    std::size_t films_open_ = 0;
    double closed_ = 0.0, total_;
    TracedFrames result_;
};

}  // namespace

TracedFrames run_frames(const FrameLoop& loop) { return Loop(loop).run(); }

std::size_t windows_of(std::size_t frames, std::size_t films) {
    // Each window costs lines that are set out anew, so that where memory is short it is better spent on long windows:
    // before the next one all threads write then, and none is idle but at the very end.
    constexpr std::size_t kBeside = 2;
    const std::size_t longest = std::max(films / 2, films - std::min(films, kBeside));
    return (frames + longest - 1) / longest;
}

std::size_t most_films(const Motion& motion, std::span<const PlannedFrame> frames) {
    std::size_t most = 1, first = 0;
    for (const MotionPiece& piece : motion.pieces) {
        while (first < frames.size() && !is_exposed_in(frames[first], piece) &&
               frames[first].exposure.end_s <= piece.when.begin_s)
            ++first;
        std::size_t end = first;
        while (end < frames.size() && is_exposed_in(frames[end], piece)) ++end;
        most = std::max(most, end - first);
    }
    return 2 * most;
}

}  // namespace overfly
