#include "shot/flight_scene.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/stopwatch.h"
#include "flight/motion.h"
#include "io/content_hash.h"
#include "shot/frame_plan.h"
#include "shot/mesh_rescan.h"
#include "terrain/flight_mesh.h"

namespace overfly {
namespace {

// Raised when the same inputs make another mesh.
constexpr int kMeshingVersion = 1;

// The refinement measures where the grid puts a place, the rescan along a vertical that may come down beside a side, on
// the next triangle. Where that makes more than is allowed, so much less is asked for; a few times are enough.
constexpr double kAskForLess = 0.98;
constexpr int kMostAttempts = 8;

// Before and after the flight exposures are reckoned with in whole steps, one at least: shutters of other frame rates
// and shots of other parts of the flight reach less far than that, and get the same mesh.
constexpr double kBeyond_s = 0.25;

double whole_steps_s(double beyond_s) { return kBeyond_s * std::max(1.0, std::ceil(beyond_s / kBeyond_s)); }

class FlightMeshMaker {
  public:
    FlightMeshMaker(Stage& stage, double pixel_error, const ClosestApproach& approach, const Progress& progress)
        : stage_(&stage), pixel_error_(pixel_error), approach_(&approach), progress_(&progress) {}

    // The stage looks at the mesh then. Returns its largest error in pixels.
    [[nodiscard]] double make() const {
        double asked_px = pixel_error_;
        double found_px = 0.0;
        for (int attempt = 0; attempt < kMostAttempts; ++attempt) {
            found_px = attempt_with(asked_px);
            if (found_px <= pixel_error_) return found_px;
            asked_px *= kAskForLess * pixel_error_ / found_px;
        }
        check(false, "the mesh for the flight is as near to all samples as it was asked to be");
        return found_px;
    }

  private:
    [[nodiscard]] double attempt_with(double asked_px) const {
        if (*progress_) (*progress_)("meshing for the flight", 0.0, 0.0);
        const auto allowed_m = [&](Point<Scene> middle, double radius_m) {
            return asked_px / approach_->pixels_per_metre(middle, radius_m);
        };
        stage_->look_at(triangulate_within(stage_->full_mesh(), stage_->frame(), allowed_m));
        return largest_mesh_error_px(stage_->full_mesh(), stage_->frame(), stage_->rays(), *approach_, *progress_);
    }

    Stage* stage_;
    double pixel_error_;
    const ClosestApproach* approach_;
    const Progress* progress_;
};

}  // namespace

ClosestApproach approach_of(const ShotDocument& shot, const CameraPath& path, const Stage& stage) {
    const TimeRange flight = path.times();
    const TimeRange exposed = exposed_times(plan_frames(shot, flight));
    const TimeRange when = {flight.begin_s - whole_steps_s(flight.begin_s - exposed.begin_s),
                            flight.end_s + whole_steps_s(exposed.end_s - flight.end_s)};
    // Not the motion that the shot is traced by: its pieces are cut to the frame rate.
    return {fit_motion(path, when, stage.surroundings(), MotionOptions{}), {shot.image.width, shot.image.height}};
}

FlightMeshReport fit_mesh_to_flight(Stage& stage, const ShotDocument& shot, const CameraPath& path,
                                    const std::filesystem::path& cache_folder, const Progress& progress) {
    const Stopwatch watch;
    FlightMeshReport report;
    report.triangles_before = report.triangles = stage.full_mesh().triangles.size();
    if (shot.mesh_pixel_error == 0.0) return report;
    const ClosestApproach approach = approach_of(shot, path, stage);
    const PreparedScene& full = stage.terrain().scene;
    const std::string hash = content_hash({}, fmt::format("flight mesh {} scene {} error {}\n{}", kMeshingVersion,
                                                          full.content_hash, shot.mesh_pixel_error, approach.text()));
    const std::filesystem::path file = cached_scene_file(cache_folder, hash);
    if (auto cached = load_scene(file); cached && cached->content_hash == hash) {
        report.largest_error_px = cached->largest_error_px;
        report.from_cache = true;
        stage.look_at(std::move(cached->mesh));
    } else {
        report.largest_error_px = FlightMeshMaker(stage, shot.mesh_pixel_error, approach, progress).make();
        try_to_save_scene(file, {hash, full.origin, full.report, stage.mesh(), report.largest_error_px});
    }
    report.triangles = stage.mesh().triangles.size();
    report.seconds = watch.seconds();
    return report;
}

}  // namespace overfly
