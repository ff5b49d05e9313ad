#include "trace/sight.h"

#include <algorithm>
#include <utility>

#include "trace/merge_by_depth.h"
#include "trace/split_by_sun.h"

namespace overfly {
namespace {

// The exposures that a stretch has any part of; an instant belongs to the stretch that begins with it.
std::vector<TimeRange> exposures_in(TimeRange when, std::span<const TimeRange> exposures) {
    std::vector<TimeRange> inside;
    for (const TimeRange& e : exposures) {
        const TimeRange open = intersection(e, when);
        const bool is_instant = e.duration_s() == 0.0;
        const bool belongs = is_instant ? open.duration_s() == 0.0 && e.begin_s < when.end_s : open.duration_s() > 0.0;
        if (belongs) inside.push_back(e);
    }
    return inside;
}

// Rays that start at the camera.
void trace_camera(const Surface& surface, const std::optional<KineticPiece>& prepared, const MotionPiece& piece,
                  std::span<const ImageSample> samples, std::span<const TimeRange> exposures, SegmentLists& lists,
                  TraceCounters& counters) {
    if (prepared) {
        surface.kinetic->trace(*prepared, samples, exposures, lists, counters);
    } else {
        trace(*surface.tracer, piece, samples, exposures, lists, counters);
    }
}

// Lists of segments by sample while surfaces are put together.
using Lists = std::vector<std::vector<SurfaceSegment>>;

// One call of SightTracer::trace.
class Following {
  public:
    Following(std::span<const Surface> surfaces, std::span<const TriangleMesh* const> meshes,
              const PreparedSight& prepared, std::span<const TimeRange> exposures, TraceCounters& counters)
        : surfaces_(surfaces),
          prepared_(&prepared),
          meshes_(meshes),
          exposures_(exposures),
          counters_(&counters),
          has_shadows_(std::ranges::any_of(surfaces, [](const Surface& s) { return s.blocker != nullptr; })) {}

    // What the samples see, mirrors followed. `before` is the sight in whose mirror this one is, if it is in any.
    Lists see(const Sight& sight, const Sight* before, TimeRange when, std::span<const ImageSample> samples) {
        Lists seen(samples.size());
        for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
            // A plane mirror doesn't see itself.
            if (s == sight.in_mirror) continue;
            add_surface(sight, before, s, when, samples, seen);
        }
        if (has_shadows_) split_by_sun(surfaces_, sight, samples, seen, *counters_);
        for (const Sight& mirrored : sight.mirrored) look_into(mirrored, sight, when, samples, seen);
        return seen;
    }

    std::vector<SurfaceSegment> take_reflected() { return std::move(reflected_); }

  private:
    void add_surface(const Sight& sight, const Sight* before, std::uint32_t surface, TimeRange when,
                     std::span<const ImageSample> samples, Lists& seen) {
        Lists found(samples.size());
        for (const MotionPiece& piece : sight.motions[surface].pieces_over(when)) {
            const std::vector<TimeRange> open = exposures_in(intersection(piece.when, when), exposures_);
            if (open.empty()) continue;
            RayStart start;
            if (before != nullptr) {
                start = {&before->motions[sight.in_mirror].piece_at(piece.when.centre_s()),
                         surfaces_[sight.in_mirror].mirror};
            }
            SegmentLists lists;
            if (before == nullptr) {
                trace_camera(surfaces_[surface], prepared_->kinetic[surface], piece, samples, open, lists, *counters_);
            } else {
                overfly::trace(*surfaces_[surface].tracer, piece, samples, open, lists, *counters_, &start);
            }
            for (std::size_t i = 0; i < samples.size(); ++i) {
                for (const VisibleSegment& v : lists.of(i)) {
                    // That terrain isn't hit at an instant is said, so that every instant is answered.
                    if (v.triangle != kNone || surface == 0)
                        found[i].push_back({surface, v.triangle, v.when, &piece, &sight});
                }
            }
        }
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (found[i].empty()) continue;
            merged_.clear();
            merge_by_depth(seen[i], found[i], meshes_, samples[i], merged_);
            std::swap(seen[i], merged_);
        }
    }

    // Cuts the stretches in which samples see a mirror by what they see in it.
    void look_into(const Sight& mirrored, const Sight& sight, TimeRange when, std::span<const ImageSample> samples,
                   Lists& seen) {
        std::vector<std::size_t> who;
        std::vector<ImageSample> lookers;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const auto is_here = [&](const SurfaceSegment& s) { return s.surface == mirrored.in_mirror; };
            if (!std::ranges::any_of(seen[i], is_here)) continue;
            who.push_back(i);
            lookers.push_back(samples[i]);
        }
        if (who.empty()) return;
        const Lists behind = see(mirrored, &sight, when, lookers);
        for (std::size_t k = 0; k < who.size(); ++k) {
            std::vector<SurfaceSegment> cut;
            for (const SurfaceSegment& s : seen[who[k]]) {
                if (s.surface == mirrored.in_mirror) {
                    cut_by(s, behind[k], mirrored, cut);
                } else {
                    cut.push_back(s);
                }
            }
            seen[who[k]] = std::move(cut);
        }
    }

    // One stretch of a mirror, cut by what is seen in it; between that is the sky.
    void cut_by(const SurfaceSegment& mirror, std::span<const SurfaceSegment> behind, const Sight& mirrored,
                std::vector<SurfaceSegment>& out) {
        const auto add = [&](SurfaceSegment what, TimeRange when) {
            what.when = when;
            out.push_back(mirror);
            out.back().when = when;
            out.back().reflected = static_cast<std::uint32_t>(reflected_.size());
            reflected_.push_back(what);
        };
        const auto add_sky = [&](TimeRange when) {
            SurfaceSegment sky;
            sky.sight = &mirrored;
            add(sky, when);
        };
        if (mirror.when.duration_s() == 0.0) {
            const auto now = std::ranges::find(behind, mirror.when, &SurfaceSegment::when);
            return now != behind.end() ? add(*now, mirror.when) : add_sky(mirror.when);
        }
        double reached_s = mirror.when.begin_s;
        for (const SurfaceSegment& s : behind) {
            const TimeRange both = intersection(s.when, mirror.when);
            if (both.duration_s() <= 0.0) continue;
            if (both.begin_s > reached_s) add_sky({reached_s, both.begin_s});
            add(s, both);
            reached_s = both.end_s;
        }
        if (reached_s < mirror.when.end_s) add_sky({reached_s, mirror.when.end_s});
    }

    std::span<const Surface> surfaces_;
    const PreparedSight* prepared_;
    std::span<const TriangleMesh* const> meshes_;
    std::span<const TimeRange> exposures_;
    TraceCounters* counters_;
    bool has_shadows_;
    std::vector<SurfaceSegment> merged_;
    std::vector<SurfaceSegment> reflected_;
};

}  // namespace

SightTracer::SightTracer(std::span<const Surface> surfaces, const Sight& sight) : surfaces_(surfaces), sight_(&sight) {
    for (const Surface& s : surfaces) meshes_.push_back(s.mesh);
}

PreparedSight SightTracer::prepare(TimeRange when, const FilmBounds& picture) const {
    PreparedSight prepared = {when, {}};
    prepared.kinetic.resize(surfaces_.size());
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
        if (surfaces_[s].kinetic == nullptr) continue;
        prepared.kinetic[s] = surfaces_[s].kinetic->prepare(sight_->motions[s].piece_at(when.centre_s()), picture);
    }
    return prepared;
}

void SightTracer::trace(const PreparedSight& prepared, std::span<const ImageSample> samples,
                        std::span<const TimeRange> exposures, SurfaceSegmentLists& out, TraceCounters& counters) const {
    if (surfaces_.size() == 1 && surfaces_.front().blocker == nullptr)
        return trace_alone(prepared, samples, exposures, out, counters);
    Following following(surfaces_, meshes_, prepared, exposures, counters);
    for (const std::vector<SurfaceSegment>& seen : following.see(*sight_, nullptr, prepared.when, samples)) {
        out.segments.insert(out.segments.end(), seen.begin(), seen.end());
        out.end_sample();
    }
    out.reflected = following.take_reflected();
}

// Nothing is nearer or further, so the answer is handed on as it is.
void SightTracer::trace_alone(const PreparedSight& prepared, std::span<const ImageSample> samples,
                              std::span<const TimeRange> exposures, SurfaceSegmentLists& out,
                              TraceCounters& counters) const {
    const MotionPiece& piece = sight_->motions.front().piece_at(prepared.when.centre_s());
    // Memory that each thread keeps.
    thread_local SegmentLists lists;
    lists.clear();
    trace_camera(surfaces_.front(), prepared.kinetic.front(), piece, samples, exposures, lists, counters);
    const auto before = static_cast<std::uint32_t>(out.segments.size());
    out.segments.reserve(before + lists.segments.size());
    for (const VisibleSegment& v : lists.segments) out.segments.push_back({0, v.triangle, v.when, &piece, sight_});
    for (const std::uint32_t end : lists.ends) out.ends.push_back(before + end);
}

}  // namespace overfly
