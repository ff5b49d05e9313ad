#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "mesh/connect_triangles.h"
#include "support/motions.h"
#include "support/terrains.h"

namespace overfly::testing {

struct NamedMotion {
    const char* name;
    MotionPiece piece;
};

// Turns the picture about the view by an angle that grows to `turn`, in steps of a quadratic.
inline MotionPiece rolling(MotionPiece piece, double turn_rad) {
    const auto through = [](const auto& f) {
        const Vector<Scene> a = f(0.0);
        const Vector<Scene> b = f(0.5);
        const Vector<Scene> c = f(1.0);
        return QuadraticVector{a, 4.0 * b - 3.0 * a - c, 2.0 * a + 2.0 * c - 4.0 * b};
    };
    const QuadraticVector right = piece.right;
    const QuadraticVector down = piece.down;
    piece.right =
        through([&](double u) { return std::cos(turn_rad * u) * right.at(u) + std::sin(turn_rad * u) * down.at(u); });
    piece.down =
        through([&](double u) { return -std::sin(turn_rad * u) * right.at(u) + std::cos(turn_rad * u) * down.at(u); });
    return piece;
}

inline std::vector<NamedMotion> all_sorts_of_motions() {
    const double pi = std::numbers::pi;
    const auto low = [](double x, double y, double above) { return Point<Scene>{x, y, rough_ground(x, y) + above}; };
    return {
        {"forward and down", HandMotion{{0, -2000, 900}, {20, 400, -30}, 0.1, -0.35, 0.05}.piece()},
        {"a fast pan", HandMotion{{-500, 0, 1500}, {10, 20, 0}, 1.0, -0.6, 1.2}.piece()},
        {"straight down", HandMotion{{100, 100, 2500}, {150, 0, 0}, 0.0, -0.5 * pi, 0.3}.piece()},
        {"a hover", HandMotion{{0, 0, 1200}, {1e-3, 0, 0}, 2.0, -0.1, 0.0}.piece()},
        {"in from outside", HandMotion{{300, -3500, 700}, {-300, 700, 0}, -0.2, 0.02, -0.2}.piece()},
        {"a barrel roll", rolling(HandMotion{{0, -800, 900}, {0, 300, 0}, 0.0, -0.3, 0.0}.piece(), 1.2)},
        {"five metres above the ground", HandMotion{low(0, 0, 5.0), {2, 1, 0.5}, 0.4, -0.1, 0.1}.piece()},
        {"backwards, up", HandMotion{low(500, 300, 100.0), {-100, -250, 200}, 0.2, -0.2, -0.1}.piece()},
        {"through the ground", HandMotion{low(200, 0, 60.0), {30, 60, -200}, 0.4, -0.1, 0.1}.piece()},
        {"below the ground", HandMotion{low(200, 0, -200.0), {100, 250, 30}, 0.4, 0.1, 0.1}.piece()},
    };
}

// A rough ground without some of its triangles: holes of one, of many, and a ragged border.
inline TriangleMesh with_holes(const TriangleMesh& whole, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    TriangleMesh mesh;
    mesh.positions = whole.positions;
    for (const auto& t : whole.triangles) {
        const Point<Scene> p = whole.positions[t[0]];
        const bool in_lake = std::hypot(p.x - 300.0, p.y - 900.0) < 350.0;
        if (!in_lake && unit(generator) > 0.05) mesh.triangles.push_back(t);
    }
    connect_triangles(mesh);
    return mesh;
}

// Sheer steps: blocks with nearly upright walls, as a lidar sees a town.
inline double town(double x, double y) {
    const auto block = [](double v) { return static_cast<int>(std::floor(v / 350.0)); };
    return 60.0 * ((7 * block(x) * block(x) + 13 * block(y) + 5 * block(x) * block(y)) & 7);
}

}  // namespace overfly::testing
