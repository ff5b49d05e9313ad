#include "trace/split_by_sun.h"

#include <algorithm>
#include <map>

namespace overfly {
namespace {

// One segment of one sample, and when it is dark.
struct Asked {
    std::size_t sample = 0, segment = 0;
    std::vector<TimeRange> dark;
};

// The sun and the one who looks are on different sides of the triangle, all through.
bool faces_away(const TriangleMesh& mesh, const SurfaceSegment& s, const ImageSample& sample) {
    const auto& corner = mesh.triangles[s.triangle];
    const Point<Scene> p0 = mesh.positions[corner[0]];
    const Vector<Scene> normal = cross(mesh.positions[corner[1]] - p0, mesh.positions[corner[2]] - p0);
    const auto is_away = [&](double time_s) {
        const double u = s.motion->u_at(time_s);
        return dot(normal, s.motion->to_sun.at(u)) * dot(normal, s.motion->direction_at(u, sample.x, sample.y)) >= 0.0;
    };
    return is_away(s.when.begin_s) && is_away(s.when.centre_s()) && is_away(s.when.end_s);
}

class SunSplit {
  public:
    SunSplit(std::span<const Surface> surfaces, const Sight& sight, std::span<const ImageSample> samples,
             TraceCounters& counters)
        : surfaces_(surfaces), sight_(&sight), samples_(samples), counters_(&counters) {}

    void run(std::vector<std::vector<SurfaceSegment>>& seen) {
        std::vector<Asked> asked;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            for (std::size_t k = 0; k < seen[i].size(); ++k) {
                if (seen[i][k].triangle == kNone) continue;
                asked.push_back({i, k, {}});
            }
        }
        for (std::uint32_t blocker = 0; blocker < surfaces_.size(); ++blocker) {
            if (surfaces_[blocker].blocker != nullptr) ask(blocker, seen, asked);
        }
        std::size_t next = 0;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            std::vector<SurfaceSegment> cut;
            for (std::size_t k = 0; k < seen[i].size(); ++k) {
                const bool was_asked = next < asked.size() && asked[next].sample == i && asked[next].segment == k;
                cut_by(seen[i][k], was_asked ? asked[next++].dark : std::vector<TimeRange>{}, cut);
            }
            seen[i] = std::move(cut);
        }
    }

  private:
    // Adds the shadows that one surface throws, motion piece by motion piece.
    void ask(std::uint32_t blocker, const std::vector<std::vector<SurfaceSegment>>& seen, std::vector<Asked>& asked) {
        struct Queries {
            std::vector<ShadowQuery> queries;
            std::vector<std::size_t> of;  // which of `asked`
        };
        std::map<const MotionPiece*, Queries> by_piece;
        for (std::size_t a = 0; a < asked.size(); ++a) {
            const SurfaceSegment& s = seen[asked[a].sample][asked[a].segment];
            if (s.surface == blocker && !surfaces_[blocker].shades_itself) continue;
            const ImageSample& sample = samples_[asked[a].sample];
            const TriangleMesh* mesh = surfaces_[s.surface].mesh;
            if (faces_away(*mesh, s, sample)) {
                // Shading by the triangle's own normal knows; by one that is smooth over many it may not.
                if (s.surface == blocker) asked[a].dark.push_back(s.when);
                continue;
            }
            for (const MotionPiece& piece : sight_->motions[blocker].pieces_over(s.when)) {
                const TimeRange when = intersection(piece.when, s.when);
                const bool is_instant = s.when.duration_s() == 0.0;
                if (is_instant ? when.begin_s >= piece.when.end_s : when.duration_s() <= 0.0) continue;
                Queries& q = by_piece[&piece];
                q.queries.push_back({sample, mesh, s.triangle, s.motion, when});
                q.of.push_back(a);
            }
        }
        for (const auto& [piece, q] : by_piece) {
            ShadowLists lists;
            trace(*surfaces_[blocker].blocker, *piece, q.queries, lists, *counters_);
            for (std::size_t k = 0; k < q.of.size(); ++k) {
                const auto dark = lists.of(k);
                asked[q.of[k]].dark.insert(asked[q.of[k]].dark.end(), dark.begin(), dark.end());
            }
        }
    }

    static void cut_by(const SurfaceSegment& s, std::vector<TimeRange> dark, std::vector<SurfaceSegment>& out) {
        const auto add = [&](TimeRange when, bool in_shadow) {
            out.push_back(s);
            out.back().when = when;
            out.back().in_shadow = in_shadow;
        };
        if (s.when.duration_s() == 0.0) return add(s.when, !dark.empty());
        std::ranges::sort(dark, {}, &TimeRange::begin_s);
        double reached_s = s.when.begin_s;
        for (const TimeRange& d : dark) {
            const TimeRange rest = {std::max(d.begin_s, reached_s), std::min(d.end_s, s.when.end_s)};
            if (rest.duration_s() <= 0.0) continue;
            if (rest.begin_s > reached_s) add({reached_s, rest.begin_s}, false);
            add(rest, true);
            reached_s = rest.end_s;
        }
        if (reached_s < s.when.end_s) add({reached_s, s.when.end_s}, false);
    }

    std::span<const Surface> surfaces_;
    const Sight* sight_;
    std::span<const ImageSample> samples_;
    TraceCounters* counters_;
};

}  // namespace

void split_by_sun(std::span<const Surface> surfaces, const Sight& sight, std::span<const ImageSample> samples,
                  std::vector<std::vector<SurfaceSegment>>& seen, TraceCounters& counters) {
    SunSplit(surfaces, sight, samples, counters).run(seen);
}

}  // namespace overfly
