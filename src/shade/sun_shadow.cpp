#include "shade/sun_shadow.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "shade/local_frame.h"
#include "shade/parallel_blocks.h"

namespace overfly {
namespace {

// The middles of the four triangles that halving the sides makes, each with a quarter of the area.
constexpr std::array<std::array<double, 3>, 4> kPlaces = {{{2.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0},
                                                           {1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0},
                                                           {1.0 / 6.0, 1.0 / 6.0, 2.0 / 3.0},
                                                           {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}}};
constexpr float kWeightOfCorner = 4.0F / 3.0F;  // the places' weights for one corner, added up

// Where on the sun each place looks: a square within the disc of 0.267 degrees.
constexpr double kSunSide_rad = 0.0033;
constexpr std::array<std::array<double, 2>, 4> kOnSun = {{{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}};

// Rays start this far above the ground, as a share of a side of the triangle: clear of float rounding.
constexpr double kLift = 0.02;

// What each corner gets of the sunlit places.
using Corners = std::array<float, 3>;

// Of triangles [first, first + lit.size()). Neighbours ask together: the sun is so small that all rays to it are alike.
void find_sunlit(const TriangleMesh& mesh, TriangleId first, const std::array<Vector<Scene>, 4>& to_sun,
                 const AreBlocked& are_blocked, std::span<Corners> lit) {
    constexpr std::size_t kCount = kPlaces.size();
    OpenRays rays(are_blocked, [&](std::size_t label) {
        for (std::size_t k = 0; k < 3; ++k) lit[label / kCount][k] += static_cast<float>(kPlaces[label % kCount][k]);
    });
    for (std::size_t t = 0; t < lit.size(); ++t) {
        const auto& ids = mesh.triangles[first + t];
        const Point<Scene> a = mesh.positions[ids[0]];
        const Vector<Scene> ab = mesh.positions[ids[1]] - a;
        const Vector<Scene> ac = mesh.positions[ids[2]] - a;
        const Vector<Scene> normal = normalized(cross(ab, ac));
        const Point<Scene> lifted = a + (kLift * length(ab)) * normal;
        for (std::size_t i = 0; i < kCount; ++i) {
            if (dot(normal, to_sun[i]) <= 0.0) continue;
            rays.add({lifted + kPlaces[i][1] * ab + kPlaces[i][2] * ac, to_sun[i]}, kCount * t + i);
        }
    }
    rays.finish();
}

}  // namespace

std::vector<float> sun_share(const TriangleMesh& mesh, Vector<Scene> to_sun, const AreBlocked& are_blocked,
                             const Progress& progress) {
    const LocalFrame f = frame_around(to_sun);
    std::array<Vector<Scene>, 4> over_sun;
    for (std::size_t i = 0; i < 4; ++i) {
        over_sun[i] = to_sun + kSunSide_rad * (kOnSun[i][0] * f.x + kOnSun[i][1] * f.y);
    }
    std::vector<Corners> lit(mesh.triangles.size());
    parallel_ranges(lit.size(), "sunlight", progress, [&](std::size_t begin, std::size_t end) {
        find_sunlit(mesh, static_cast<TriangleId>(begin), over_sun, are_blocked,
                    std::span(lit).subspan(begin, end - begin));
    });

    std::vector<float> share(mesh.positions.size(), 0.0F);
    std::vector<float> whole(mesh.positions.size(), 0.0F);
    for (std::size_t t = 0; t < lit.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            share[mesh.triangles[t][k]] += lit[t][k];
            whole[mesh.triangles[t][k]] += kWeightOfCorner;
        }
    }
    for (std::size_t v = 0; v < share.size(); ++v) {
        if (whole[v] > 0.0F) share[v] /= whole[v];
    }
    return share;
}

}  // namespace overfly
