#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace overfly {

// A hierarchy of boxes that stand still while the ray moves, flat in memory, depth first.
struct StaticBvh {
    // An inner node holds the boxes of its two children, rounded outward to float.
    struct Node {
        std::array<std::array<float, 3>, 2> low, high;
        std::array<std::uint32_t, 2>
            child;                          // index of a node, or of a leaf's first entry in `triangles` with kLeaf set
        std::array<std::uint32_t, 2> size;  // triangles in the leaf; 0 for an inner node
    };

    std::vector<Node> nodes;  // the root first
    std::vector<TriangleId> triangles;
    float slack_m = 0.0F;  // more than any rounding of a coordinate of the mesh to float
    int depth = 0;         // nodes on the longest way down

    [[nodiscard]] bool empty() const { return nodes.empty(); }
};

// What a triangle lies in.
struct TriangleBox {
    std::array<float, 3> low, high;  // finite
    TriangleId triangle = kNone;
};

// By the surface area heuristic, through Embree's builder.
// GUARANTEES: every box in one leaf; the same hierarchy whatever the number of threads.
[[nodiscard]] StaticBvh build_bvh(std::span<const TriangleBox> boxes);

// Over the triangles where they stand.
[[nodiscard]] StaticBvh build_static_bvh(const TriangleMesh& mesh);

}  // namespace overfly
