#include "trace/inflated.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/rounded_float.h"
#include "trace/sample_line.h"

namespace overfly {
namespace {

// Depth in the units of the hierarchy. A still film point meets a box as often as its area across the depth says, so
// that is what the surface area heuristic has to see: with a unit this long the sides hardly count, and yet tell boxes
// of one area apart. A power of two loses nothing of the depth.
constexpr double kDepthUnit_m = 0x1p27;

constexpr std::size_t kStack = 128;  // twice the deepest hierarchy that build_bvh makes
constexpr float kInfinity = std::numeric_limits<float>::infinity();

StaticBvh build(const TriangleMesh& mesh, const MotionPiece& piece, FilmReach reach) {
    const FilmBoxes volumes(mesh, piece, reach);
    std::vector<TriangleBox> boxes;
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) {
        const std::optional<FilmBox> box = volumes.of(t);
        if (!box) continue;
        boxes.push_back(
            {{rounded_down(box->low[0]), rounded_down(box->low[1]), rounded_down(box->low[2] / kDepthUnit_m)},
             {rounded_up(box->high[0]), rounded_up(box->high[1]), rounded_up(box->high[2] / kDepthUnit_m)},
             t});
    }
    return build_bvh(boxes);
}

// Gathers the records of one sample.
class Walk {
  public:
    Walk(const StaticBvh& bvh, const SampleLine& line, const ImageSample& sample, TraceCounters& counters)
        : bvh_(&bvh), line_(&line), x_(sample.x), y_(sample.y), counters_(&counters) {}

    std::vector<CellRecord> run() {
        if (bvh_->empty()) return {};
        struct Entry {
            std::uint32_t node;
            float enter;
        };
        std::array<Entry, kStack> stack;
        std::size_t height = 0;
        stack[height++] = {0, 0.0F};
        while (height > 0) {
            const Entry entry = stack[--height];
            if (entry.enter > far_) continue;
            const StaticBvh::Node& node = bvh_->nodes[entry.node];
            const std::array<float, 2> enter = {enter_depth(node, 0), enter_depth(node, 1)};
            const std::size_t near = enter[1] < enter[0] ? 1 : 0;
            for (const std::size_t k : {near, 1 - near}) {
                if (enter[k] == kInfinity || node.size[k] == 0) continue;
                for (std::uint32_t i = 0; i < node.size[k]; ++i) test(bvh_->triangles[node.child[k] + i]);
            }
            for (const std::size_t k : {1 - near, near}) {
                if (enter[k] != kInfinity && node.size[k] == 0) stack[height++] = {node.child[k], enter[k]};
            }
        }
        return std::move(records_);
    }

  private:
    // Infinite where the film point is outside of the box, or the box is hidden.
    float enter_depth(const StaticBvh::Node& node, std::size_t k) {
        ++counters_->box_tests;
        const auto within = [&](double at, std::size_t axis) {
            return static_cast<double>(node.low[k][axis]) <= at && at <= static_cast<double>(node.high[k][axis]);
        };
        const bool met = within(x_, 0) && within(y_, 1) && node.low[k][2] <= far_;
        if (!met) return kInfinity;
        ++counters_->box_hits;
        return node.low[k][2];
    }

    void test(TriangleId triangle) {
        ++counters_->triangle_tests;
        const std::size_t before = records_.size();
        if (!line_->add_records(triangle, records_)) return;
        ++counters_->triangle_hits;
        if (records_.size() > before) update_far();
    }

    // Nothing behind records that together cover the piece can be seen.
    void update_far() {
        std::ranges::sort(records_, [](const CellRecord& a, const CellRecord& b) {
            return a.begin != b.begin ? a.begin < b.begin : a.farthest_m < b.farthest_m;
        });
        double reach = 0.0;
        double far_m = 0.0;
        for (const CellRecord& r : records_) {
            if (r.begin > reach) return;
            if (r.end > reach) far_m = std::max(far_m, r.farthest_m);
            reach = std::max(reach, r.end);
        }
        if (reach >= 1.0) far_ = std::min(far_, rounded_up(far_m / kDepthUnit_m));
    }

    const StaticBvh* bvh_;
    const SampleLine* line_;
    double x_, y_;
    TraceCounters* counters_;
    std::vector<CellRecord> records_;
    float far_ = std::numeric_limits<float>::max();
};

}  // namespace

InflatedTracer::InflatedTracer(const TriangleMesh& mesh, const MotionPiece& piece, FilmReach reach)
    : mesh_(&mesh), piece_(&piece), bvh_(build(mesh, piece, reach)) {}

void InflatedTracer::trace(std::span<const ImageSample> samples, SegmentLists& out, TraceCounters& counters) const {
    const std::size_t before = out.segments.size();
    for (const ImageSample& sample : samples) {
        const SampleLine line(*mesh_, *piece_, sample, piece_->when);
        line.append_segments(line.nearest(Walk(bvh_, line, sample, counters).run()), out.segments);
        out.end_sample();
    }
    counters.rays += samples.size();
    counters.segments += out.segments.size() - before;
}

}  // namespace overfly
