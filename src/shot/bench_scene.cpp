#include "shot/bench_scene.h"

#include <algorithm>
#include <utility>

#include "shot/frame_loop.h"
#include "shot/memory_plan.h"
#include "shot/processor_time.h"
#include "shot/shot_motion.h"
#include "shot/shot_sight.h"

namespace overfly {

BenchScene::BenchScene(const ShotDocument& shot, const std::filesystem::path& cache_folder, const Progress& progress)
    : shot_(&shot),
      stage_(prepare_terrain(shot.terrain, cache_folder, progress), middle_of(shot.flight)),
      path_(make_path(shot.flight, stage_)),
      frames_(plan_frames(shot, path_.times())),
      bodies_(make_bodies(shot, stage_)),
      mesh_(fit_mesh_to_flight(stage_, shot, path_, cache_folder, progress)),
      day_(shot.look.look),
      sight_(make_sight(shot, path_, shot_motion(shot, path_, frames_, stage_), {stage_, bodies_, day_.to_sun()})),
      light_(shot, stage_, day_, {}, progress),
      shader_(light_.shader(bodies_)) {}

ShotTracers BenchScene::tracers(const SamplingDocument& sampling) const {
    ShotDocument asked = *shot_;
    asked.sampling = sampling;
    return {asked, stage_, bodies_, sight_};
}

Exposing BenchScene::exposing(const ShotTracers& tracers) const {
    return {tracers.pair(), shader_, size(), {}, frames_, {}, shot_->shutter.curve, tracers.filter()};
}

std::size_t BenchScene::films(const Motion& motion, std::span<const PlannedFrame> frames) const {
    const ShotTracers any = tracers(shot_->sampling);
    const FramesInMemory needed = {exposing(any).film_bytes(), thread_limit(), most_films(motion, frames)};
    return plan_memory(*shot_, scene_memory(sizes_of(*shot_, stage_, bodies_)), needed).frames;
}

std::vector<BenchWork> bench_work(const BenchScene& scene, std::size_t pieces) {
    std::vector<const MotionPiece*> exposed;
    for (const MotionPiece& piece : scene.motion().pieces) {
        if (std::ranges::any_of(scene.frames(), [&](const PlannedFrame& f) { return is_exposed_in(f, piece); }))
            exposed.push_back(&piece);
    }
    std::vector<BenchWork> out;
    const std::size_t count = std::min(pieces, exposed.size());
    for (std::size_t k = 0; k < count; ++k) {
        const MotionPiece& piece = *exposed[(2 * k + 1) * exposed.size() / (2 * count)];
        BenchWork work = {{&piece, 1}, {}};
        for (const PlannedFrame& f : scene.frames()) {
            if (!is_exposed_in(f, piece)) continue;
            work.frames.push_back(f);
            work.frames.back().exposure = intersection(f.exposure, piece.when);
        }
        out.push_back(std::move(work));
    }
    return out;
}

BenchWork middle_frame(const BenchScene& scene) {
    const PlannedFrame& frame = scene.frames()[scene.frames().size() / 2];
    std::span<const MotionPiece> pieces = scene.motion().pieces_over(frame.exposure);
    while (pieces.size() > 1 && !is_exposed_in(frame, pieces.front())) pieces = pieces.subspan(1);
    return {pieces, {frame}};
}

Exposed expose(const Exposing& exposing, const BenchWork& work) {
    std::vector<FilmFrame> films;
    for (const PlannedFrame& frame : work.frames) films.push_back(exposing.film(frame));
    TraceCounters counters;
    Exposed out;
    const double start_s = processor_seconds();
    for (const MotionPiece& piece : work.pieces) {
        std::vector<PlannedFrame> frames;
        std::vector<FilmFrame*> in_piece;
        for (std::size_t k = 0; k < work.frames.size(); ++k) {
            if (!is_exposed_in(work.frames[k], piece)) continue;
            frames.push_back(work.frames[k]);
            in_piece.push_back(&films[k]);
        }
        if (!frames.empty()) expose_piece(exposing, piece, frames, in_piece, counters);
    }
    out.seconds = processor_seconds() - start_s;
    for (FilmFrame& film : films) out.frames.push_back(std::move(film).develop().frame);
    return out;
}

}  // namespace overfly
