#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/colour.h"
#include "core/float4.h"
#include "mesh/triangle_mesh.h"
#include "shade/are_blocked.h"
#include "shade/local_frame.h"

namespace overfly {

// Directions spread evenly over the half of space around z, and the light that comes from each.
struct SkyDirection {
    Vector<Scene> towards;
    Rgb radiance;
};
// Neighbouring vertices look into different sets.
inline constexpr std::uint32_t kSkySets = 4;
using SkySet = std::array<SkyDirection, 24>;
using SkySets = std::array<SkySet, kSkySets>;

// Vertices near each other: enough that those that look into one set fill packets of rays that start near each other
// and run in one direction.
class SkyBlock {
  public:
    static constexpr std::size_t kSize = 256;

    // vertices: at most kSize, which must outlive the block. normals: of each vertex of the mesh.
    SkyBlock(const TriangleMesh& mesh, std::span<const Vector<Scene>> normals, std::span<const VertexId> vertices);

    // Light over pi of a sky without ground before it, all sets together: on the i-th of the block's vertices.
    [[nodiscard]] std::array<Rgb, kSize> unhindered(const SkySets& sets) const;

    // open[v], for each vertex v of the block that looks into set number `set`: of the light that comes from there to
    // its slope, the share that no ground keeps off.
    void find_open(const SkySets& sets, std::uint32_t set, const AreBlocked& are_blocked, std::span<float> open) const;

  private:
    [[nodiscard]] float facing(std::size_t i, Vector<Scene> d) const {
        return static_cast<float>(d.x) * x_[i / 4][i % 4] + static_cast<float>(d.y) * y_[i / 4][i % 4] +
               static_cast<float>(d.z) * z_[i / 4][i % 4];
    }

    std::span<const VertexId> vertices_;
    std::array<LocalFrame, kSize> frame_;
    std::array<Point<Scene>, kSize> from_;           // where rays start
    std::array<Float4, kSize / 4> x_{}, y_{}, z_{};  // normals in the vertices' own frames, of four in each
};

}  // namespace overfly
