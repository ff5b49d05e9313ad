#include "shade/sky_block.h"

#include <vector>

#include "shade/daylight.h"

namespace overfly {
namespace {

constexpr double kLift_m = 1.0;  // of the rays' origins: clear of float rounding within some 100 km

float brightness(Rgb c) { return 0.2126F * c.r + 0.7152F * c.g + 0.0722F * c.b; }  // Rec. 709 luminance

std::uint32_t set_of(VertexId vertex) {
    static_assert(kSkySets == 4);
    return (vertex * 2654435761U) >> 30U;
}

}  // namespace

SkyBlock::SkyBlock(const TriangleMesh& mesh, std::span<const Vector<Scene>> normals, std::span<const VertexId> vertices)
    : vertices_(vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Point<Scene> p = mesh.positions[vertices[i]];
        const Vector<Scene> n = normals[vertices[i]];
        frame_[i] = frame_around(up_at(p));
        from_[i] = p + kLift_m * n;
        x_[i / 4][i % 4] = static_cast<float>(dot(n, frame_[i].x));
        y_[i / 4][i % 4] = static_cast<float>(dot(n, frame_[i].y));
        z_[i / 4][i % 4] = static_cast<float>(dot(n, frame_[i].z));
    }
}

std::array<Rgb, SkyBlock::kSize> SkyBlock::unhindered(const SkySets& sets) const {
    std::array<Rgb, kSize> light;
    for (std::size_t four = 0; four < kSize / 4; ++four) {
        Float4 r = {}, g = {}, b = {};
        for (const SkySet& set : sets) {
            for (const SkyDirection& d : set) {
                const Float4 cosine = static_cast<float>(d.towards.x) * x_[four] +
                                      static_cast<float>(d.towards.y) * y_[four] +
                                      static_cast<float>(d.towards.z) * z_[four];
                const Float4 facing = cosine > 0.0F ? cosine : Float4{};
                r += d.radiance.r * facing;
                g += d.radiance.g * facing;
                b += d.radiance.b * facing;
            }
        }
        for (std::size_t k = 0; k < 4; ++k) light[4 * four + k] = (1.0F / kSkySets) * Rgb{r[k], g[k], b[k]};
    }
    return light;
}

void SkyBlock::find_open(const SkySets& sets, std::uint32_t set, const AreBlocked& are_blocked,
                         std::span<float> open) const {
    std::vector<std::size_t> members;
    members.reserve(kSize);
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        if (set_of(vertices_[i]) == set) members.push_back(i);
    }
    std::array<float, kSize> share{}, all{}, reaching{};
    OpenRays rays(are_blocked, [&](std::size_t i) { reaching[i] += share[i]; });
    for (const SkyDirection& d : sets[set]) {
        for (const std::size_t i : members) {
            const float cosine = facing(i, d.towards);
            if (cosine <= 0.0F) continue;
            share[i] = cosine * brightness(d.radiance);
            all[i] += share[i];
            const LocalFrame& f = frame_[i];
            rays.add({from_[i], d.towards.x * f.x + d.towards.y * f.y + d.towards.z * f.z}, i);
        }
        rays.finish();  // for another direction is another share
    }
    for (const std::size_t i : members) open[vertices_[i]] = all[i] > 0.0F ? reaching[i] / all[i] : 1.0F;
}

}  // namespace overfly
