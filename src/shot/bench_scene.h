#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "core/progress.h"
#include "film/frame.h"
#include "shot/expose_piece.h"
#include "shot/flight_scene.h"
#include "shot/scene_light.h"
#include "shot/shot_tracers.h"

namespace overfly {

// One thread while it lives.
class OneThread {
  public:
    OneThread() : before_(thread_limit()) { limit_threads(1); }
    ~OneThread() { limit_threads(before_); }
    OneThread(const OneThread&) = delete;
    OneThread& operator=(const OneThread&) = delete;

  private:
    int before_;
};

// All that a shot is exposed by, so that tracers with different sampling can be held against each other.
class BenchScene {
  public:
    BenchScene(const ShotDocument& shot, const std::filesystem::path& cache_folder, const Progress& progress);
    BenchScene(const BenchScene&) = delete;
    BenchScene& operator=(const BenchScene&) = delete;

    [[nodiscard]] const ShotDocument& shot() const { return *shot_; }
    [[nodiscard]] const Stage& stage() const { return stage_; }
    [[nodiscard]] const CameraPath& path() const { return path_; }
    [[nodiscard]] const FlightMeshReport& mesh() const { return mesh_; }
    [[nodiscard]] const Motion& motion() const { return sight_.motions.front(); }
    [[nodiscard]] std::span<const PlannedFrame> frames() const { return frames_; }
    [[nodiscard]] PictureSize size() const { return {shot_->image.width, shot_->image.height}; }

    // REQUIRES: this outlives them.
    [[nodiscard]] ShotTracers tracers(const SamplingDocument& sampling) const;
    [[nodiscard]] Exposing exposing(const ShotTracers& tracers) const;
    // How many films a render of these frames has at once.
    [[nodiscard]] std::size_t films(const Motion& motion, std::span<const PlannedFrame> frames) const;

  private:
    const ShotDocument* shot_;
    Stage stage_;
    CameraPath path_;
    std::vector<PlannedFrame> frames_;
    ShotBodies bodies_;
    FlightMeshReport mesh_;
    Daylight day_;
    Sight sight_;
    SceneLight light_;
    SceneShader shader_;
};

// Pieces of the shot's motion that follow each other, and frames, which count as far as they are exposed in those.
struct BenchWork {
    std::span<const MotionPiece> pieces;
    std::vector<PlannedFrame> frames;
};

// A frame in the middle of the shot, and all pieces that it is exposed in.
[[nodiscard]] BenchWork middle_frame(const BenchScene& scene);

// Single pieces, evenly spread over those of the shot that have a frame in them, at most `pieces`, with the parts of
// exposures that lie in each.
[[nodiscard]] std::vector<BenchWork> bench_work(const BenchScene& scene, std::size_t pieces);

struct Exposed {
    std::vector<Frame> frames;
    double seconds = 0.0;  // of this thread's processor time
};
[[nodiscard]] Exposed expose(const Exposing& exposing, const BenchWork& work);

}  // namespace overfly
