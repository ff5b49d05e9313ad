#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "trace/paper_scene.h"

namespace overfly {

// The paper's hierarchy of bounding volumes: a box around each polygon, boxes around boxes. All tracers walk the same
// tree; what differs is what the boxes have to contain.
struct PaperBox {
    std::array<double, 6> bound{};  // low x, y, z, high x, y, z
};

struct PaperNode {
    static constexpr std::uint32_t kWorld = kNone;  // stands still

    PaperBox box{};
    std::uint32_t second = 0;       // child; the first is the next node
    std::uint32_t polygon = kNone;  // of a leaf
    std::uint32_t body = kWorld;    // that carries the box
    std::uint32_t axis = 0;         // along which the children lie, the first lower
};

// Depth first, the root first.
using PaperHierarchy = std::vector<PaperNode>;

// No node has more above it.
inline constexpr std::size_t kPaperDeepest = 128;

// The tree: by the surface area heuristic over the places of the polygons half-way through the animation. Its boxes are
// those of that instant. REQUIRES: a polygon.
[[nodiscard]] PaperHierarchy build_paper_hierarchy(const PaperScene& scene);

// The same tree, boxes and all, at one instant: what a program that knows nothing of time builds for each frame.
void set_boxes_at(const PaperScene& scene, double u, PaperHierarchy& hierarchy);

// The paper's bounding volumes (its section 3): boxes that contain their polygons at all times and stand still.
void set_boxes_always(const PaperScene& scene, PaperHierarchy& hierarchy);

// Ours: boxes of exact size that are carried along by the body of their polygons, to which the ray is swept. A box that
// standing still would hardly enlarge, or that has polygons of several bodies, stands still as the paper's do.
void set_boxes_carried(const PaperScene& scene, PaperHierarchy& hierarchy);

}  // namespace overfly
