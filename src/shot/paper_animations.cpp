#include "shot/paper_animations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/error.h"
#include "io/elevation_file.h"
#include "terrain/triangulate.h"

namespace overfly {
namespace {

// 50 degrees across, square pixels.
constexpr double kHalfWidth = 0.4663;
constexpr double kHalfHeight = kHalfWidth * 400.0 / 512.0;

// Looks north and down by `pitch_rad`.
PaperCamera camera_at(Point<Scene> eye, double pitch_rad) {
    PaperCamera camera;
    camera.eye = eye;
    const Vector<Scene> view = {0.0, std::cos(pitch_rad), -std::sin(pitch_rad)};
    const Vector<Scene> right = {kHalfWidth, 0.0, 0.0};
    const Vector<Scene> down = kHalfHeight * cross(view, Vector<Scene>{1.0, 0.0, 0.0});
    camera.per_column = 2.0 / camera.columns * right;
    camera.per_row = 2.0 / camera.rows * down;
    camera.first = view - right - down + 0.5 * camera.per_column + 0.5 * camera.per_row;
    return camera;
}

// A rectangle in the plane `depth_m` in front of a level camera at the origin, from one film point to another.
void add_rectangle(PaperScene& scene, double depth_m, std::array<double, 2> low, std::array<double, 2> high) {
    const auto first_corner = static_cast<std::uint32_t>(scene.corners.size());
    for (const auto& [x, y] : {low, {high[0], low[1]}, high, {low[0], high[1]}}) {
        scene.corners.push_back(static_cast<VertexId>(scene.positions.size()));
        scene.positions.push_back({x * kHalfWidth * depth_m, depth_m, -y * kHalfHeight * depth_m});
    }
    scene.polygons.push_back({first_corner, 4, static_cast<std::uint32_t>(scene.bodies.size() - 1)});
}

PaperScene one_polygon() {
    PaperScene scene;
    scene.camera = camera_at({}, 0.0);
    scene.bodies.emplace_back();
    add_rectangle(scene, 10.0, {-1.1, -1.1}, {1.1, 1.1});
    return scene;
}

PaperScene two_polygons() {
    // A square of side s, in shares of the picture, that goes from corner to corner sweeps 2 s - s^2 of it.
    constexpr double kSide = 0.3675;
    constexpr double kDepth_m = 5.0;
    PaperScene scene = one_polygon();
    const double way = 2.0 * (1.0 - kSide) * kDepth_m;
    scene.bodies.push_back({{way * kHalfWidth, 0.0, way * kHalfHeight}, {}});
    add_rectangle(scene, kDepth_m, {-1.0, 1.0 - 2.0 * kSide}, {-1.0 + 2.0 * kSide, 1.0});
    return scene;
}

// 35 x 35 of the samples that a terrain document names, with their places.
TerrainMesh coarse_terrain(const TerrainDocument& document) {
    const ElevationFile fine = read_elevation(document.source);
    const ElevationModel& model = *fine.model;
    if (model.columns < kPaperSamples || model.rows < kPaperSamples) {
        throw UserError({document.file}, fmt::format("the terrain has {} x {} samples; at least {} x {} are needed",
                                                     model.columns, model.rows, kPaperSamples, kPaperSamples));
    }
    const auto chosen = [](int i, int count) {
        return static_cast<int>(std::lround(static_cast<double>(i) * (count - 1) / (kPaperSamples - 1)));
    };
    ElevationModel coarse;
    coarse.columns = coarse.rows = kPaperSamples;
    for (int row = 0; row < kPaperSamples; ++row) {
        for (int column = 0; column < kPaperSamples; ++column) {
            const std::size_t i = model.index(chosen(column, model.columns), chosen(row, model.rows));
            coarse.height_m.push_back(model.height_m[i]);
            coarse.is_valid.push_back(model.is_valid[i]);
        }
    }
    if (std::ranges::count(coarse.is_valid, std::uint8_t{0}) > 0) {
        throw UserError({document.file}, fmt::format("the terrain has no height at one of {} x {} places",
                                                     kPaperSamples, kPaperSamples));
    }
    const LocateRow locate = [&](int row, std::span<Geodetic> places) {
        std::vector<Geodetic> all(static_cast<std::size_t>(model.columns));
        fine.locate(chosen(row, model.rows), all);
        for (std::size_t k = 0; k < places.size(); ++k) {
            places[k] = all[static_cast<std::size_t>(chosen(static_cast<int>(k), model.columns))];
        }
    };
    return triangulate(coarse, SceneFrame({fine.centre.lon, fine.centre.lat, 0.0}), locate);
}

PaperScene fly_by(const TerrainMesh& mesh) {
    PaperScene scene;
    scene.positions = mesh.positions;
    for (const auto& corners : mesh.triangles) {
        scene.polygons.push_back({static_cast<std::uint32_t>(scene.corners.size()), 3, 0});
        scene.corners.insert(scene.corners.end(), corners.begin(), corners.end());
    }
    Point<Scene> low = mesh.positions.front();
    Point<Scene> high = low;
    for (const Point<Scene>& p : mesh.positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    // From just inside the southern edge, at the height of the highest summit and a fifth of the relief more, straight
    // to the north and a little to the east. Placed in shares of the terrain's size.
    constexpr double kPitch_rad = 5.5 * std::numbers::pi / 180.0;
    const Vector<Scene> size = high - low;
    scene.camera = camera_at(low + Vector<Scene>{0.35 * size.x, 0.05 * size.y, 1.2 * size.z}, kPitch_rad);
    // The camera stands still, the ground moves.
    scene.bodies.push_back({{-0.02 * size.x, -0.103 * size.y, 0.0}, {}});
    return scene;
}

}  // namespace

std::vector<PaperAnimation> paper_animations(const TerrainDocument& terrain) {
    return {{"static_polygon", "one static polygon that fills the image", one_polygon()},
            {"crossing_polygon", "a small polygon crossing in front of a large one", two_polygons()},
            {"fly_by", "a fly-by of 2,312 polygons of real terrain", fly_by(coarse_terrain(terrain))}};
}

}  // namespace overfly
