#include "shade/ground_light.h"

#include <algorithm>
#include <cstddef>

#include "shade/patchiness.h"
#include "shade/sky_light.h"
#include "shade/sun_shadow.h"

namespace overfly {
namespace {

// Albedo of the surroundings that light a vertex from below its horizon: dry soil and rock.
constexpr Rgb kAlbedoAround = {0.28F, 0.24F, 0.19F};

}  // namespace

Rgb ground_around(const Daylight& day) {
    const auto level_sun = static_cast<float>(std::max(day.to_sun().z, 0.0));
    return kAlbedoAround * (level_sun * day.sun() + day.sky());
}

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
                         const AreBlocked& are_blocked, const GroundLightOptions& options, const Progress& progress) {
    const std::vector<Vector<Scene>> normals = vertex_normals(mesh);
    std::vector<float> sunlit(mesh.positions.size(), 1.0F);
    if (options.shadows == GroundShadows::Baked) sunlit = sun_share(mesh, day.to_sun(), are_blocked, progress);
    const std::vector<SkyLight> sky = sky_light(mesh, normals, day, are_blocked, progress);
    const Rgb around = ground_around(day);

    GroundLight light;
    light.radiance.reserve(mesh.positions.size());
    light.without_sun.reserve(mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const auto facing_sun = static_cast<float>(std::max(dot(normals[v], day.to_sun()), 0.0));
        const auto slope_cos = static_cast<float>(dot(normals[v], up_at(mesh.positions[v])));
        const Rgb from_around = sky[v].irradiance + sky[v].ground_share * around;
        const float stray_m = colours.stray_m > 0.0F ? colours.stray_m * patchiness(mesh.positions[v]) : 0.0F;
        const Rgb albedo = colours.at(mesh.elevation_m[v] + stray_m, slope_cos);
        light.without_sun.push_back(albedo * from_around);
        if (options.with_parts) {
            light.albedo.push_back(albedo);
            light.sunlight.push_back(albedo * (facing_sun * day.sun()));
        }
        light.radiance.push_back(albedo * ((sunlit[v] * facing_sun) * day.sun() + from_around));
    }
    return light;
}

}  // namespace overfly
