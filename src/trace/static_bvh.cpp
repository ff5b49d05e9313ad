#include "trace/static_bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <span>

#include <embree3/rtcore.h>

#include "core/error.h"
#include "core/rounded_float.h"

namespace overfly {
namespace {

// A swept ray pays about as much for one triangle as for a handful of boxes, so leaves are small.
constexpr unsigned kMostInLeaf = 2;
constexpr unsigned kMostDepth = 60;

struct Box {
    std::array<float, 3> low, high;
};

// The tree as Embree's builder makes it, before it is laid out flat.
struct BuildNode {
    std::array<BuildNode*, 2> child{};
    std::array<Box, 2> box{};
    std::array<TriangleId, kMostInLeaf> triangle{};
    unsigned size = 0;  // of a leaf
};

void* make_node(RTCThreadLocalAllocator allocator, unsigned, void*) {
    return new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode();
}

void set_children(void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<BuildNode*>(node)->child[i] = static_cast<BuildNode*>(children[i]);
}

void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) {
        const RTCBounds& b = *bounds[i];
        static_cast<BuildNode*>(node)->box[i] = {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
    }
}

void* make_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive* primitives, std::size_t count, void*) {
    auto* leaf = new (rtcThreadLocalAlloc(allocator, sizeof(BuildNode), alignof(BuildNode))) BuildNode();
    leaf->size = static_cast<unsigned>(count);
    for (std::size_t i = 0; i < count; ++i) leaf->triangle[i] = primitives[i].primID;
    return leaf;
}

TriangleBox box_of(const TriangleMesh& mesh, TriangleId triangle) {
    Point<Scene> low = mesh.positions[mesh.triangles[triangle][0]];
    Point<Scene> high = low;
    for (std::size_t k = 1; k < 3; ++k) {
        const Point<Scene>& p = mesh.positions[mesh.triangles[triangle][k]];
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return {{rounded_down(low.x), rounded_down(low.y), rounded_down(low.z)},
            {rounded_up(high.x), rounded_up(high.y), rounded_up(high.z)},
            triangle};
}

RTCBuildPrimitive primitive_of(const TriangleBox& box) {
    RTCBuildPrimitive primitive{};
    primitive.lower_x = box.low[0];
    primitive.lower_y = box.low[1];
    primitive.lower_z = box.low[2];
    primitive.upper_x = box.high[0];
    primitive.upper_y = box.high[1];
    primitive.upper_z = box.high[2];
    primitive.primID = box.triangle;
    return primitive;
}

// Lays the tree out depth first; returns what a parent stores for `node`.
class Flattener {
  public:
    explicit Flattener(StaticBvh& bvh) : bvh_(&bvh) {}

    void add_root(const BuildNode& root, const Box& everything) {
        if (root.size == 0) {
            add_inner(root, 1);
            return;
        }
        // A mesh that fits into one leaf: a root whose second child is empty.
        const Box nowhere = {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
        bvh_->nodes.push_back({{everything.low, nowhere.low}, {everything.high, nowhere.high}, {}, {root.size, 1}});
        add_leaf(root);
        bvh_->depth = 1;
    }

  private:
    static constexpr float kFar = std::numeric_limits<float>::max();

    std::uint32_t add_leaf(const BuildNode& leaf) {
        const auto first = static_cast<std::uint32_t>(bvh_->triangles.size());
        for (unsigned i = 0; i < leaf.size; ++i) bvh_->triangles.push_back(leaf.triangle[i]);
        return first;
    }
    std::uint32_t add_inner(const BuildNode& node, int depth) {
        bvh_->depth = std::max(bvh_->depth, depth);
        const auto index = static_cast<std::uint32_t>(bvh_->nodes.size());
        bvh_->nodes.push_back({{node.box[0].low, node.box[1].low}, {node.box[0].high, node.box[1].high}, {}, {}});
        for (std::size_t k = 0; k < 2; ++k) {
            const BuildNode& child = *node.child[k];
            const std::uint32_t at = child.size > 0 ? add_leaf(child) : add_inner(child, depth + 1);
            bvh_->nodes[index].child[k] = at;
            bvh_->nodes[index].size[k] = child.size;
        }
        return index;
    }

    StaticBvh* bvh_;
};

struct DeviceRelease {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct BvhRelease {
    void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
};

}  // namespace

StaticBvh build_bvh(std::span<const TriangleBox> boxes) {
    StaticBvh flat;
    if (boxes.empty()) return flat;
    std::vector<RTCBuildPrimitive> primitives;
    primitives.reserve(boxes.size());
    Box everything = {boxes[0].low, boxes[0].high};
    for (const TriangleBox& b : boxes) {
        primitives.push_back(primitive_of(b));
        for (std::size_t k = 0; k < 3; ++k) {
            everything.low[k] = std::min(everything.low[k], b.low[k]);
            everything.high[k] = std::max(everything.high[k], b.high[k]);
            flat.slack_m = std::max({flat.slack_m, std::abs(b.low[k]), std::abs(b.high[k])});
        }
    }
    flat.slack_m *= 0x1p-21F;

    const std::unique_ptr<std::remove_pointer_t<RTCDevice>, DeviceRelease> device(rtcNewDevice(nullptr));
    const std::unique_ptr<std::remove_pointer_t<RTCBVH>, BvhRelease> bvh(rtcNewBVH(device.get()));
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    arguments.maxBranchingFactor = 2;
    arguments.maxDepth = kMostDepth;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = kMostInLeaf;
    arguments.traversalCost = 1.0F;
    arguments.intersectionCost = 4.0F;
    arguments.bvh = bvh.get();
    arguments.primitives = primitives.data();
    arguments.primitiveCount = primitives.size();
    arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = make_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = make_leaf;
    const auto* root = static_cast<const BuildNode*>(rtcBuildBVH(&arguments));
    check(root != nullptr, "Embree builds a hierarchy");
    flat.nodes.reserve(boxes.size());
    flat.triangles.reserve(boxes.size());
    Flattener(flat).add_root(*root, everything);
    return flat;
}

StaticBvh build_static_bvh(const TriangleMesh& mesh) {
    std::vector<TriangleBox> boxes;
    boxes.reserve(mesh.triangles.size());
    for (TriangleId t = 0; t < mesh.triangles.size(); ++t) boxes.push_back(box_of(mesh, t));
    return build_bvh(boxes);
}

}  // namespace overfly
