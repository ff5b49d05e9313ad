#include "shade/ground_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <numbers>

#include "core/low_discrepancy.h"
#include "core/parallel.h"

namespace overfly {
namespace {

// Directions are the same for every vertex: the error is a smooth bias instead of noise from vertex to vertex.
constexpr std::uint32_t kSkyDirections = 48;
constexpr std::uint32_t kSunDirections = 6;
constexpr std::uint64_t kSeed = 1991;

// Half the width of the sun's disc, widened to what vertices tens of metres apart can resolve.
constexpr double kSunRadius_rad = 0.012;

// Albedo of the surroundings that light a vertex from below its horizon.
constexpr float kBounceAlbedo = 0.35F;

constexpr std::size_t kBlock = 4096;  // vertices in a task

struct LocalFrame {
    Vector<Scene> x, y, z;
};

// Two unit vectors square to z (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
LocalFrame frame_around(Vector<Scene> z) {
    const double sign = std::copysign(1.0, z.z);
    const double a = -1.0 / (sign + z.z);
    const double b = z.x * z.y * a;
    return {{1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x}, {b, sign + z.y * z.y * a, -z.y}, z};
}

// Cosine-weighted directions over the upper half of a frame, so that each stands for the same irradiance.
std::array<Vector<Scene>, kSkyDirections> sky_directions() {
    std::array<Vector<Scene>, kSkyDirections> directions;
    for (std::uint32_t i = 0; i < kSkyDirections; ++i) {
        const auto p = low_discrepancy_point(kSeed, i);
        const double radius = std::sqrt(p[0]);
        const double turn = 2.0 * std::numbers::pi * p[1];
        directions[i] = {radius * std::cos(turn), radius * std::sin(turn), std::sqrt(1.0 - p[0])};
    }
    return directions;
}

std::array<Vector<Scene>, kSunDirections> sun_directions(Vector<Scene> to_sun) {
    const LocalFrame f = frame_around(to_sun);
    std::array<Vector<Scene>, kSunDirections> directions;
    for (std::uint32_t i = 0; i < kSunDirections; ++i) {
        const auto p = low_discrepancy_point(kSeed + 1, i);
        const double radius = kSunRadius_rad * std::sqrt(p[0]);
        const double turn = 2.0 * std::numbers::pi * p[1];
        directions[i] = to_sun + (radius * std::cos(turn)) * f.x + (radius * std::sin(turn)) * f.y;
    }
    return directions;
}

double mean_side_m(const TerrainMesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) sum += distance(mesh.positions[t[0]], mesh.positions[t[1]]);
    return sum / std::max<double>(1.0, static_cast<double>(mesh.triangles.size()));
}

}  // namespace

std::vector<Vector<Scene>> vertex_normals(const TerrainMesh& mesh) {
    std::vector<Vector<Scene>> normals(mesh.positions.size());
    for (const auto& t : mesh.triangles) {
        const Point<Scene> a = mesh.positions[t[0]];
        const Vector<Scene> twice_area = cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
        for (const VertexId v : t) normals[v] = normals[v] + twice_area;
    }
    for (Vector<Scene>& n : normals) {
        const double l = length(n);
        n = l > 0.0 ? n / l : Vector<Scene>{0.0, 0.0, 1.0};
    }
    return normals;
}

GroundLight light_ground(const TerrainMesh& mesh, const ColourRamp& colours, const Daylight& day,
                         const IsBlocked& is_blocked, const Progress& progress) {
    const std::vector<Vector<Scene>> normals = vertex_normals(mesh);
    const auto over_sky = sky_directions();
    const auto over_sun = sun_directions(day.to_sun());
    // Rays start this far above the vertex, clear of the triangles that meet in it and of float rounding.
    const double lift_m = 0.02 * mean_side_m(mesh);
    GroundLight light;
    light.radiance.resize(mesh.positions.size());

    const auto light_vertex = [&](std::size_t v) {
        const Vector<Scene> normal = normals[v];
        const Point<Scene> from = mesh.positions[v] + lift_m * normal;
        const LocalFrame f = frame_around(normal);
        int open = 0;
        for (const Vector<Scene>& d : over_sky) {
            if (!is_blocked(from, d.x * f.x + d.y * f.y + d.z * f.z)) ++open;
        }
        const double facing = dot(normal, day.to_sun());
        int lit = 0;
        if (facing > 0.0) {
            for (const Vector<Scene>& d : over_sun) lit += is_blocked(from, d) ? 0 : 1;
        }
        const float sky_share = static_cast<float>(open) / static_cast<float>(kSkyDirections);
        const float sun_share = static_cast<float>(lit) / static_cast<float>(kSunDirections);
        const Rgb direct = (sun_share * static_cast<float>(std::max(facing, 0.0))) * day.sun();
        const auto level_sun = static_cast<float>(std::max(day.to_sun().z, 0.0));
        const Rgb around = kBounceAlbedo * (level_sun * day.sun() + day.sky());
        const Rgb irradiance = direct + sky_share * day.sky() + (1.0F - sky_share) * around;
        light.radiance[v] = colours.at(mesh.elevation_m[v]) * irradiance;
    };

    const std::size_t blocks = (mesh.positions.size() + kBlock - 1) / kBlock;
    std::mutex mutex;
    std::size_t done = 0;
    parallel_for(blocks, [&](std::size_t block) {
        const std::size_t end = std::min(mesh.positions.size(), (block + 1) * kBlock);
        for (std::size_t v = block * kBlock; v < end; ++v) light_vertex(v);
        if (!progress) return;
        const std::scoped_lock lock(mutex);
        progress("lighting the ground", static_cast<double>(++done), static_cast<double>(blocks));
    });
    return light;
}

}  // namespace overfly
