#pragma once

#include <span>

#include <hwy/targets.h>

#include "config/read.h"
#include "io/temporary_folder.h"
#include "shade/hypsometric.h"
#include "shot/flight_scene.h"
#include "shot/frame_plan.h"
#include "shot/shot_motion.h"
#include "shot/shot_sight.h"
#include "shot/shot_tracers.h"

namespace overfly::testing {

inline constexpr PictureSize kGliderSize = {96, 54};

// The glider's shot, which has all that a line may meet, in a small picture; over the full mesh with a pixel_error of
// 0, over a coarser one else.
class GliderShot {
  public:
    explicit GliderShot(double pixel_error) {
        shot_.mesh_pixel_error = pixel_error;
        shot_.image.width = kGliderSize.width;
        shot_.image.height = kGliderSize.height;
        fit_mesh_to_flight(stage_, shot_, path_, folder_ / "cache");
        bodies_ = make_bodies(shot_, stage_);
        const std::vector<PlannedFrame> frames = plan_frames(shot_, path_.times());
        sight_ = make_sight(shot_, path_, shot_motion(shot_, path_, frames, stage_), {stage_, bodies_, day_.to_sun()});
    }

    [[nodiscard]] const TerrainMesh& mesh() const { return stage_.mesh(); }
    [[nodiscard]] const TerrainMesh& full_mesh() const { return stage_.full_mesh(); }
    [[nodiscard]] const LitGround& light() const { return light_; }
    // A piece of the motion, from 0 at the begin to 1 at the end of the shot.
    [[nodiscard]] const MotionPiece& piece(double place) const {
        const std::vector<MotionPiece>& pieces = sight_.motions.front().pieces;
        return pieces[static_cast<std::size_t>(place * static_cast<double>(pieces.size() - 1))];
    }
    [[nodiscard]] SceneShader shader() const {
        std::vector<ShadedBody> shaded;
        for (const auto& body : bodies_)
            shaded.push_back({&body->mesh(), {body->document().albedo, body->document().mirror}});
        return {mesh(), light_, day_, false, std::move(shaded)};
    }
    // What lines through the picture see.
    [[nodiscard]] SurfaceSegmentLists traced(std::span<const ImageSample> lines, const MotionPiece& piece) const {
        const ShotTracers tracers(shot_, stage_, bodies_, sight_);
        const PreparedSight prepared = tracers.pair().continuous->prepare(piece.when, kGliderSize.film_bounds());
        const std::vector<TimeRange> exposures = {piece.when};
        SurfaceSegmentLists lists;
        TraceCounters counters;
        tracers.pair().continuous->trace(prepared, lines, exposures, lists, counters);
        return lists;
    }

  private:
    TemporaryFolder folder_;
    ShotDocument shot_ = read_shot_document(OVERFLY_SOURCE_DIR "/configs/glider.yaml", {});
    Daylight day_{shot_.look.look};
    Stage stage_{prepare_terrain(shot_.terrain, folder_ / "cache"), middle_of(shot_.flight)};
    CameraPath path_ = make_path(shot_.flight, stage_);
    // Nothing hides the sky from the ground, which takes a while to find out.
    LitGround light_{stage_.full_mesh(),
                     light_ground(stage_.full_mesh(), hypsometric_ramp(0.0F, 5000.0F), day_,
                                  [](std::span<const LightRay>) { return 0U; }, {GroundShadows::Traced})};
    ShotBodies bodies_;
    Sight sight_;
};

inline std::vector<ImageSample> lines_through_all_pixels() {
    std::vector<ImageSample> lines;
    for (const PixelTile& tile : tiles_of(kGliderSize)) {
        const TileSamples of_tile = samples_of(tile, kGliderSize, 1);
        lines.insert(lines.end(), of_tile.samples.begin(), of_tile.samples.end());
    }
    return lines;
}

// Calls with each vector unit that the processor offers, in turn the one that Highway chooses.
template <class WithTarget>
void for_each_vector_unit(const WithTarget& with_target) {
    for (std::int64_t rest = hwy::SupportedTargets() & HWY_TARGETS; rest != 0; rest &= rest - 1) {
        const std::int64_t target = rest & -rest;
        hwy::SetSupportedTargetsForTest(target);
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        with_target(hwy::TargetName(target));
    }
    hwy::SetSupportedTargetsForTest(0);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

}  // namespace overfly::testing
