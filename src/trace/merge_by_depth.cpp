#include "trace/merge_by_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/polynomial_roots.h"
#include "trace/plane_depth.h"

namespace overfly {
namespace {

class Merge {
  public:
    Merge(std::span<const TriangleMesh* const> meshes, const ImageSample& sample, std::vector<SurfaceSegment>& out)
        : meshes_(meshes), sample_(&sample), out_(&out), first_(out.size()) {}

    // Both lists from front to back, from one time at which either begins or ends to the next.
    void run(std::span<const SurfaceSegment> a, std::span<const SurfaceSegment> b) {
        double reached_s = -std::numeric_limits<double>::infinity();
        const auto drop_past = [&](std::span<const SurfaceSegment>& list) {
            while (!list.empty() && list.front().when.end_s <= reached_s) list = list.subspan(1);
        };
        while (!a.empty() && !b.empty()) {
            const TimeRange of_a = a.front().when;
            const TimeRange of_b = b.front().when;
            const double from_s = std::max(reached_s, std::min(of_a.begin_s, of_b.begin_s));
            if (of_a.begin_s > from_s) {
                reached_s = std::min(of_b.end_s, of_a.begin_s);
                add(b.front(), {from_s, reached_s});
            } else if (of_b.begin_s > from_s) {
                reached_s = std::min(of_a.end_s, of_b.begin_s);
                add(a.front(), {from_s, reached_s});
            } else {
                reached_s = std::min(of_a.end_s, of_b.end_s);
                decide(a.front(), b.front(), {from_s, reached_s});
            }
            drop_past(a);
            drop_past(b);
        }
        for (const SurfaceSegment& rest : a.empty() ? b : a) {
            add(rest, {std::max(reached_s, rest.when.begin_s), rest.when.end_s});
        }
    }

  private:
    [[nodiscard]] PlaneDepth depth_of(const SurfaceSegment& s) const {
        return {*meshes_[s.surface], s.triangle, *s.motion, sample_->x, sample_->y};
    }

    // All through `when`, in which their depths don't cross.
    [[nodiscard]] const SurfaceSegment& nearer(const SurfaceSegment& a, const SurfaceSegment& b, TimeRange when) const {
        if (a.triangle == kNone || b.triangle == kNone) return a.triangle == kNone ? b : a;
        // In the middle; and elsewhere, for that may be the one time at which they touch.
        for (const double share : {0.5, 0.375}) {
            const double time_s = when.begin_s + share * when.duration_s();
            const double of_a = depth_of(a).at(a.motion->u_at(time_s));
            const double of_b = depth_of(b).at(b.motion->u_at(time_s));
            if (of_a != of_b) return of_a < of_b ? a : b;
        }
        return a.surface > b.surface ? a : b;
    }

    // Both last through `when`.
    void decide(const SurfaceSegment& a, const SurfaceSegment& b, TimeRange when) {
        if (when.duration_s() == 0.0) {
            add(nearer(a, b, when), when);
            return;
        }
        double from_s = when.begin_s;
        const auto decide_until = [&](double to_s) {
            if (to_s <= from_s) return;
            add(nearer(a, b, {from_s, to_s}), {from_s, to_s});
            from_s = to_s;
        };
        if (a.triangle != kNone && b.triangle != kNone) {
            for (const double u : crossings(a, b, when)) decide_until(when.begin_s + u * when.duration_s());
        }
        decide_until(when.end_s);
    }

    [[nodiscard]] Roots<4> crossings(const SurfaceSegment& a, const SurfaceSegment& b, TimeRange when) const {
        const PlaneDepth of_a = depth_of(a);
        const PlaneDepth of_b = depth_of(b);
        const double a0 = a.motion->u_at(when.begin_s), a1 = a.motion->u_at(when.end_s);
        const double b0 = b.motion->u_at(when.begin_s), b1 = b.motion->u_at(when.end_s);
        const Bernstein<4> left = of_a.numerator_over(a0, a1) * of_b.denominator_over(b0, b1);
        const Bernstein<4> right = of_b.numerator_over(b0, b1) * of_a.denominator_over(a0, a1);
        Bernstein<4> difference{};
        for (std::size_t k = 0; k < difference.size(); ++k) difference[k] = left[k] - right[k];
        return sign_change_roots<4>(difference);
    }

    static bool is_same(const SurfaceSegment& a, SurfaceSegment b) {
        b.when = a.when;
        return a == b;
    }

    void add(const SurfaceSegment& s, TimeRange when) {
        const bool is_instant = s.when.duration_s() == 0.0;
        if (when.duration_s() < 0.0 || (when.duration_s() == 0.0 && !is_instant)) return;
        const bool goes_on =
            !is_instant && out_->size() > first_ && out_->back().when.end_s == when.begin_s && is_same(out_->back(), s);
        if (goes_on) {
            out_->back().when.end_s = when.end_s;
        } else {
            out_->push_back(s);
            out_->back().when = when;
        }
    }

    std::span<const TriangleMesh* const> meshes_;
    const ImageSample* sample_;
    std::vector<SurfaceSegment>* out_;
    std::size_t first_;
};

}  // namespace

void merge_by_depth(std::span<const SurfaceSegment> a, std::span<const SurfaceSegment> b,
                    std::span<const TriangleMesh* const> meshes, const ImageSample& sample,
                    std::vector<SurfaceSegment>& out) {
    Merge(meshes, sample, out).run(a, b);
}

}  // namespace overfly
