#include "shot/shot_sight.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "shot/shot_motion.h"

namespace overfly {
namespace {

// Joints nearer to each other than this are one.
constexpr double kSameJoint_s = 1e-6;

std::vector<double> joints_of(const Motion& motion) {
    std::vector<double> joints = {motion.pieces.front().when.begin_s};
    for (const MotionPiece& piece : motion.pieces) joints.push_back(piece.when.end_s);
    return joints;
}

// All of `cuts`, and those of `more` that lie between them and apart from them.
std::vector<double> with(const std::vector<double>& cuts, const std::vector<double>& more) {
    std::vector<double> all = cuts;
    for (const double joint_s : more) {
        const auto next = std::ranges::lower_bound(all, joint_s);
        const bool apart = next != all.begin() && next != all.end() && *next - joint_s > kSameJoint_s &&
                           joint_s - *(next - 1) > kSameJoint_s;
        if (apart) all.insert(next, joint_s);
    }
    return all;
}

// Somebody who looks at the whole scene.
struct Looker {
    std::function<RayFrame(double time_s)> rays_at;     // in the scene
    std::function<double(double time_s)> nearest_m_at;  // nothing counts that is nearer
    std::vector<double> cuts_s;
};

class SightMaker {
  public:
    SightMaker(const ShotDocument& shot, const SightSubjects& subjects)
        : subjects_(&subjects), options_(motion_options(shot)) {}

    Sight make(const Looker& looker, Motion of_terrain, std::uint32_t in_mirror, int mirrors_left) const {
        Sight sight;
        sight.in_mirror = in_mirror;
        sight.motions.push_back(std::move(of_terrain));
        for (std::uint32_t s = 1; s <= subjects_->bodies.size(); ++s) {
            sight.motions.push_back(s == in_mirror ? Motion{} : motion_of_body(looker, s));
        }
        if (mirrors_left == 0) return sight;
        for (std::uint32_t s = 1; s <= subjects_->bodies.size(); ++s) {
            if (s == in_mirror || !body(s).is_mirror()) continue;
            const Looker mirrored = in_mirror_of(looker, s, joints_of(sight.motions[s]));
            sight.mirrored.push_back(make(mirrored, motion_of_terrain(mirrored), s, mirrors_left - 1));
        }
        return sight;
    }

  private:
    [[nodiscard]] const ShotBody& body(std::uint32_t surface) const { return *subjects_->bodies[surface - 1]; }

    [[nodiscard]] Motion motion_of_body(const Looker& looker, std::uint32_t surface) const {
        const ShotBody& b = body(surface);
        const auto pose_at = [&](double time_s) { return b.path().pose_at(time_s); };
        const View view = {[&](double time_s) { return seen_from(pose_at(time_s), looker.rays_at(time_s)); },
                           [&](double time_s, Point<Scene> origin) {
                               const Reach reach = b.reach_from(origin);
                               return Reach{std::max(reach.nearest_m, looker.nearest_m_at(time_s)), reach.farthest_m};
                           },
                           [&](double time_s) { return seen_from(pose_at(time_s), subjects_->to_sun); }};
        return fit_motion(view, with(looker.cuts_s, b.path().joints_s()), options_);
    }

    [[nodiscard]] Motion motion_of_terrain(const Looker& looker) const {
        const View view = {looker.rays_at,
                           [&](double time_s, Point<Scene> origin) {
                               const double ground_m = subjects_->stage.rays().distance_m(origin);
                               return Reach{std::max(ground_m, looker.nearest_m_at(time_s))};
                           },
                           [&](double) { return subjects_->to_sun; }};
        return fit_motion(view, looker.cuts_s, options_);
    }

    // The one who looks into a mirror, behind it.
    [[nodiscard]] Looker in_mirror_of(const Looker& looker, std::uint32_t surface, std::vector<double> cuts_s) const {
        const ShotBody* mirror = &body(surface);
        return {[=](double time_s) {
                    return mirrored(looker.rays_at(time_s), in_scene(mirror->path().pose_at(time_s), mirror->plane()));
                },
                [=](double time_s) {
                    const RayFrame before = seen_from(mirror->path().pose_at(time_s), looker.rays_at(time_s));
                    return std::max(looker.nearest_m_at(time_s), mirror->reach_from(before.origin).nearest_m);
                },
                std::move(cuts_s)};
    }

    const SightSubjects* subjects_;
    MotionOptions options_;
};

}  // namespace

Sight make_sight(const ShotDocument& shot, const CameraPath& path, Motion camera, const SightSubjects& subjects) {
    for (MotionPiece& piece : camera.pieces) piece.to_sun = {subjects.to_sun, {}, {}};
    const Looker looker = {[&](double time_s) { return ray_frame(path.pose_at(time_s)); }, [](double) { return 0.0; },
                           joints_of(camera)};
    return SightMaker(shot, subjects).make(looker, std::move(camera), kNone, shot.sampling.mirror_depth);
}

double largest_error_px(const Sight& sight) {
    double largest = 0.0;
    for (const Motion& motion : sight.motions) largest = std::max(largest, motion.largest_error_px);
    for (const Sight& mirrored : sight.mirrored) largest = std::max(largest, largest_error_px(mirrored));
    return largest;
}

}  // namespace overfly
