#include "trace/paper_discrete.h"

#include <algorithm>
#include <limits>

#include "trace/paper_polygons.h"
#include "trace/paper_ray.h"

namespace overfly {
namespace {

// One frame: everything stands still.
class Frame {
  public:
    Frame(const PaperCamera& camera, const PaperHierarchy& tree, const PaperPolygons& polygons)
        : camera_(&camera), tree_(&tree), polygons_(&polygons) {}

    [[nodiscard]] std::uint32_t nearest_polygon(int row, int column, PaperCounters& counters) const {
        const PaperDirection direction(camera_->direction(row, column));
        const PaperStillRay ray(direction, camera_->eye);
        const Vector<Scene> origin = camera_->eye - Point<Scene>{};
        const Vector<Scene> moment = cross(origin, direction.d);
        Nearest nearest;
        std::array<std::uint32_t, kPaperDeepest> waiting;
        std::size_t waiting_count = 0;
        for (std::uint32_t index = 0;;) {
            const PaperNode& node = (*tree_)[index];
            ++counters.bv_tests;
            if (ray.meets(node.box, nearest.depth)) {
                ++counters.bv_hits;
                if (node.polygon == kNone) {
                    const bool from_behind = direction.is_backward(node.axis);
                    waiting[waiting_count++] = from_behind ? index + 1 : node.second;
                    index = from_behind ? node.second : index + 1;
                    continue;
                }
                ++counters.poly_tests;
                if (test_polygon(node.polygon, origin, direction.d, moment, nearest)) ++counters.poly_hits;
            }
            if (waiting_count == 0) return nearest.polygon;
            index = waiting[--waiting_count];
        }
    }

  private:
    struct Nearest {
        double depth = std::numeric_limits<double>::infinity();
        std::uint32_t polygon = kNone;
    };

    [[nodiscard]] bool test_polygon(std::uint32_t index, Vector<Scene> origin, Vector<Scene> d, Vector<Scene> moment,
                                    Nearest& nearest) const {
        const PaperPolygons::Polygon& polygon = polygons_->polygons[index];
        const double facing = dot(polygon.normal, d);
        for (const PaperPolygons::Edge& edge : polygons_->edges_of(polygon)) {
            if (is_outside(edge.at(d, moment), facing)) return false;
        }
        const double depth = (polygon.offset - dot(polygon.normal, origin)) / facing;
        if (!(depth > 0.0 && depth < std::numeric_limits<double>::infinity())) return false;
        if (depth < nearest.depth || (depth == nearest.depth && index < nearest.polygon)) nearest = {depth, index};
        return true;
    }

    const PaperCamera* camera_;
    const PaperHierarchy* tree_;
    const PaperPolygons* polygons_;
};

}  // namespace

PaperCounters trace_paper_discrete(const PaperScene& scene, const PaperHierarchy& tree, PaperFrames& out) {
    PaperCounters counters;
    PaperHierarchy boxes = tree;
    PaperPolygons polygons;
    for (int frame = 0; frame < scene.frames; ++frame) {
        set_boxes_at(scene, scene.u_of(frame), boxes);
        polygons_at(scene, scene.u_of(frame), polygons);
        const Frame still(scene.camera, boxes, polygons);
        for (int row = 0; row < scene.camera.rows; ++row) {
            for (int left = 0; left < scene.camera.columns; left += PaperFrames::kBlock) {
                PaperFrames::Pixel* block = out.block(frame, row, left);
                const int right = std::min(left + PaperFrames::kBlock, scene.camera.columns);
                for (int column = left; column < right; ++column) {
                    const std::uint32_t seen = still.nearest_polygon(row, column, counters);
                    block[column - left] = static_cast<PaperFrames::Pixel>(seen);
                }
            }
        }
    }
    return counters;
}

}  // namespace overfly
