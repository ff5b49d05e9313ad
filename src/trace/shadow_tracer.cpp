#include "trace/shadow_tracer.h"

#include <algorithm>

#include "trace/swept_shadow.h"

namespace overfly {
namespace {

TimeRange time_of(const Stretch& s, TimeRange when) {
    const auto at = [&](double u) { return std::min(when.begin_s + u * when.duration_s(), when.end_s); };
    return {s.begin == 0.0 ? when.begin_s : at(s.begin), s.end == 1.0 ? when.end_s : at(s.end)};
}

void append(const std::vector<Stretch>& dark, TimeRange when, std::vector<TimeRange>& out) {
    for (const Stretch& s : dark) {
        const TimeRange range = time_of(s, when);
        if (range.duration_s() > 0.0) out.push_back(range);
    }
    // Nothing changes during an instant but by rounding.
    if (when.duration_s() == 0.0 && !dark.empty()) out.push_back(when);
}

template <std::size_t kSunDegree>
class Following {
  public:
    Following(const TriangleMesh& mesh, const StaticBvh& bvh, const MotionPiece& motion)
        : mesh_(&mesh), bvh_(&bvh), motion_(&motion) {}

    void follow(std::span<const ShadowQuery> queries, ShadowLists& out, TraceCounters& counters) {
        const ShadowCells<kSunDegree> cells(*mesh_, *motion_, queries);
        gather_shadows(*bvh_, cells, dark_, counters);
        for (std::size_t i = 0; i < queries.size(); ++i) {
            append(dark_[i], queries[i].when, out.dark);
            out.ends.push_back(static_cast<std::uint32_t>(out.dark.size()));
            dark_[i].clear();
        }
    }

  private:
    const TriangleMesh* mesh_;
    const StaticBvh* bvh_;
    const MotionPiece* motion_;
    DarkStretches dark_;
};

}  // namespace

void ShadowTracer::trace(const MotionPiece& motion, std::span<const ShadowQuery> queries, ShadowLists& out,
                         TraceCounters& counters) const {
    const auto follow_all = [&](auto following) {
        for (std::size_t first = 0; first < queries.size(); first += kTimeCells) {
            const std::size_t count = std::min(kTimeCells, queries.size() - first);
            following.follow(queries.subspan(first, count), out, counters);
        }
    };
    const std::size_t before = out.dark.size();
    if (sun_turns(motion)) {
        follow_all(Following<2>(*mesh_, *bvh_, motion));
    } else {
        follow_all(Following<0>(*mesh_, *bvh_, motion));
    }
    counters.rays += queries.size();
    counters.segments += out.dark.size() - before;
}

}  // namespace overfly
