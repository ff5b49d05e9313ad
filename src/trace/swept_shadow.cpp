// Compiled once for each vector unit (Highway); the best that the processor offers runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/swept_shadow.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>

#include "trace/box_walk-inl.h"
#include "trace/inside_stretches.h"
#include "trace/plane_depth.h"
#include "trace/swept_shadow.h"
#include "trace/triangle_sides-inl.h"

HWY_BEFORE_NAMESPACE();
namespace overfly {
namespace HWY_NAMESPACE {

// Notes when lines towards the sun pass through triangles.
template <std::size_t kSunDegree>
class ShadowWalk {
  public:
    using Cells = ShadowCells<kSunDegree>;

    ShadowWalk(const StaticBvh& bvh, const Cells& cells, DarkStretches& dark, TraceCounters& counters)
        : bvh_(&bvh), cells_(&cells), dark_(&dark), counters_(&counters), sides_(cells.lines), depths_(cells.active) {}

    void run() {
        Sweep sweep;
        sweep_origins({&cells_->point_low, &cells_->point_high, cells_->piece->reference}, bvh_->slack_m, sweep);
        sweep_directions<kSunDegree>(cells_->sun, sweep);
        BoxWalk(*bvh_, sweep, depths_, *counters_, *this).run();
    }

    // What BoxWalk does with a triangle.
    void operator()(TriangleId triangle, std::uint32_t cells) {
        ++counters_->triangle_tests;
        const TriangleMesh& mesh = *cells_->mesh;
        const Point<Scene> reference = cells_->piece->reference;
        const SideMasks masks = sides_.evaluate(edge_functions(mesh, triangle, reference), cells);
        if (masks.perhaps_inside == 0) return;
        const Vector<Scene> normal = PlaneDepth::normal_of(mesh, triangle);
        const double offset = dot(normal, mesh.positions[mesh.triangles[triangle][0]] - reference);
        bool hit = false;
        for (std::uint32_t rest = masks.perhaps_inside; rest != 0; rest &= rest - 1) {
            const auto cell = static_cast<std::size_t>(std::countr_zero(rest));
            if (cells_->seen[cell] == triangle || is_done(cell)) continue;
            const PolynomialLineInCell<Cells::kSide, 4> line = {sides_.in(cell), numerator(normal, offset, cell)};
            for (const Stretch& s : inside_stretches(line)) {
                hit = true;
                if (s.end - s.begin > cells_->blink[cell]) add(cell, s);
            }
        }
        if (hit) ++counters_->triangle_hits;
    }

  private:
    [[nodiscard]] bool is_done(std::size_t cell) const { return depths_.farthest[cell] < 0.0F; }

    // The way from the seen point P to the plane is (N.v0 w - N.P_h) / (w N.L).
    [[nodiscard]] Bernstein<4> numerator(Vector<Scene> normal, double offset, std::size_t cell) const {
        Bernstein<4> n;
        for (std::size_t j = 0; j < 5; ++j) {
            const Vector<Scene> p = {cells_->point[0][j][cell], cells_->point[1][j][cell], cells_->point[2][j][cell]};
            n[j] = offset * cells_->weight[j][cell] - dot(normal, p);
        }
        return n;
    }

    // Unites a stretch with those that are there, and ends the search when they are the whole cell.
    void add(std::size_t cell, Stretch s) {
        std::vector<Stretch>& list = (*dark_)[cell];
        const double blink = cells_->blink[cell];
        const auto first = std::ranges::find_if(list, [&](const Stretch& l) { return l.end + blink >= s.begin; });
        const auto last = std::find_if(first, list.end(), [&](const Stretch& l) { return l.begin > s.end + blink; });
        if (first != last) s = {std::min(s.begin, first->begin), std::max(s.end, std::prev(last)->end)};
        if (s.begin <= blink) s.begin = 0.0;
        if (s.end >= 1.0 - blink) s.end = 1.0;
        list.insert(list.erase(first, last), s);
        if (s.begin == 0.0 && s.end == 1.0) depths_.end_at(cell, -1.0F);
    }

    const StaticBvh* bvh_;
    const Cells* cells_;
    DarkStretches* dark_;
    TraceCounters* counters_;
    TriangleSides<Cells::kSide> sides_;
    LookedAt depths_;
};

void still_sun(const StaticBvh& bvh, const ShadowCells<0>& cells, DarkStretches& dark, TraceCounters& counters) {
    ShadowWalk<0>(bvh, cells, dark, counters).run();
}

void turning_sun(const StaticBvh& bvh, const ShadowCells<2>& cells, DarkStretches& dark, TraceCounters& counters) {
    ShadowWalk<2>(bvh, cells, dark, counters).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace overfly
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace overfly {
HWY_EXPORT(still_sun);
HWY_EXPORT(turning_sun);

void gather_shadows(const StaticBvh& bvh, const ShadowCells<0>& cells, DarkStretches& dark, TraceCounters& counters) {
    HWY_DYNAMIC_DISPATCH(still_sun)(bvh, cells, dark, counters);
}

void gather_shadows(const StaticBvh& bvh, const ShadowCells<2>& cells, DarkStretches& dark, TraceCounters& counters) {
    HWY_DYNAMIC_DISPATCH(turning_sun)(bvh, cells, dark, counters);
}
}  // namespace overfly
#endif
