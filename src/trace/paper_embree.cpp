#include "trace/paper_embree.h"

#include <algorithm>
#include <limits>

#include "trace/ray_scene.h"

namespace overfly {
namespace {

// The polygons of one body as fans of triangles.
struct Fans {
    TriangleMesh mesh;
    std::vector<std::uint32_t> polygon;  // of each triangle

    Fans(const PaperScene& scene, std::uint32_t body) {
        mesh.positions = scene.positions;
        for (std::uint32_t p = 0; p < scene.polygons.size(); ++p) {
            const PaperPolygon& fan = scene.polygons[p];
            if (fan.body != body) continue;
            const VertexId* corner = scene.corners.data() + fan.first_corner;
            for (std::uint32_t k = 2; k < fan.corners; ++k) {
                mesh.triangles.push_back({corner[0], corner[k - 1], corner[k]});
                polygon.push_back(p);
            }
        }
    }
};

struct Nearest {
    RayPacket::Lane<float> depth;
    RayPacket::Lane<std::uint32_t> polygon;
};

// The rays of the pixels of a row from a column on, against one body that has gone some way.
void aim(const PaperCamera& camera, Vector<Scene> gone, int row, int column, RayPacket& packet) {
    for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
        const int at = column + static_cast<int>(i);
        packet.aim(i, -gone, camera.direction(row, at), at < camera.columns);
    }
}

void keep_nearer(const RayPacket& packet, const Fans& fans, Nearest& nearest) {
    for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
        if (packet.triangle[i] == kNone || packet.depth[i] >= nearest.depth[i]) continue;
        nearest.depth[i] = packet.depth[i];
        nearest.polygon[i] = fans.polygon[packet.triangle[i]];
    }
}

}  // namespace

void trace_paper_embree(const PaperScene& scene, PaperFrames& out) {
    std::vector<Fans> fans;
    std::vector<RayScene> bodies;
    for (std::uint32_t body = 0; body < scene.bodies.size(); ++body) fans.emplace_back(scene, body);
    for (const Fans& f : fans) bodies.emplace_back(f.mesh, scene.camera.eye);
    constexpr int kSize = static_cast<int>(RayPacket::kSize);
    static_assert(PaperFrames::kBlock % kSize == 0);
    RayPacket packet;
    for (int frame = 0; frame < scene.frames; ++frame) {
        for (int row = 0; row < scene.camera.rows; ++row) {
            for (int column = 0; column < scene.camera.columns; column += kSize) {
                Nearest nearest;
                nearest.depth.fill(std::numeric_limits<float>::infinity());
                nearest.polygon.fill(kNone);
                for (std::size_t body = 0; body < bodies.size(); ++body) {
                    aim(scene.camera, scene.bodies[body].at(scene.u_of(frame)), row, column, packet);
                    bodies[body].first_hits(packet);
                    keep_nearer(packet, fans[body], nearest);
                }
                PaperFrames::Pixel* pixels = out.block(frame, row, column) + column % PaperFrames::kBlock;
                std::ranges::transform(nearest.polygon, pixels,
                                       [](std::uint32_t p) { return static_cast<PaperFrames::Pixel>(p); });
            }
        }
    }
}

}  // namespace overfly
