#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "terrain/terrain_mesh.h"

namespace overfly::testing {

// A closed sheet of columns x rows vertices, spacing apart, centred on the scene's origin, at height z(x, y).
inline TerrainMesh heightfield(int columns, int rows, double spacing_m,
                               const std::function<double(double, double)>& z) {
    TerrainMesh mesh;
    for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) {
            const double x = (c - 0.5 * (columns - 1)) * spacing_m;
            const double y = (0.5 * (rows - 1) - r) * spacing_m;
            mesh.positions.push_back({x, y, z(x, y)});
            mesh.elevation_m.push_back(static_cast<float>(z(x, y)));
            mesh.samples.push_back({c, r});
        }
    }
    const auto vertex = [&](int c, int r) { return static_cast<VertexId>(r * columns + c); };
    const auto triangle = [&](int c, int r, int k) { return static_cast<TriangleId>(2 * (r * (columns - 1) + c) + k); };
    for (int r = 0; r + 1 < rows; ++r) {
        for (int c = 0; c + 1 < columns; ++c) {
            // Split from the north-west corner to the south-east one. First: NW SW SE. Second: NW SE NE.
            mesh.triangles.push_back({vertex(c, r), vertex(c, r + 1), vertex(c + 1, r + 1)});
            mesh.triangles.push_back({vertex(c, r), vertex(c + 1, r + 1), vertex(c + 1, r)});
            const HalfEdgeId west = c > 0 ? 4 * triangle(c - 1, r, 1) + 1 : kNone;
            const HalfEdgeId south = r + 2 < rows ? 4 * triangle(c, r + 1, 1) + 2 : kNone;
            const HalfEdgeId east = c + 2 < columns ? 4 * triangle(c + 1, r, 0) + 0 : kNone;
            const HalfEdgeId north = r > 0 ? 4 * triangle(c, r - 1, 0) + 1 : kNone;
            mesh.twins.push_back({west, south, 4 * triangle(c, r, 1) + 0});
            mesh.twins.push_back({4 * triangle(c, r, 0) + 2, east, north});
        }
    }
    return mesh;
}

// Ridges of several sizes, deterministic.
inline double rough_ground(double x, double y) {
    double z = 0.0;
    double amplitude = 400.0;
    double wave = 1.0 / 900.0;
    for (int octave = 0; octave < 6; ++octave) {
        z += amplitude * std::sin(wave * x + 1.3 * octave) * std::cos(wave * 1.13 * y - 0.7 * octave);
        amplitude *= 0.45;
        wave *= 2.1;
    }
    return z;
}

}  // namespace overfly::testing
