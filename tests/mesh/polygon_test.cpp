#include "mesh/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <utility>

namespace overfly {
namespace {

using Triangles = std::vector<std::array<std::size_t, 3>>;

Vector<Scene> twice_area(Point<Scene> a, Point<Scene> b, Point<Scene> c) { return cross(b - a, c - a); }

// By the shoelace formula, as a vector across the ring.
Vector<Scene> twice_area(const Polygon& ring) {
    Vector<Scene> sum;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum = sum + twice_area(ring[0], ring[i], ring[i + 1]);
    return sum;
}

// All that triangulate_polygon guarantees.
void expect_tiles(const Polygon& ring) {
    ASSERT_EQ(polygon_fault(ring), std::nullopt);
    const Triangles triangles = triangulate_polygon(ring);
    ASSERT_EQ(triangles.size(), ring.size() - 2);
    const Vector<Scene> whole = twice_area(ring);
    const double tolerance = 1e-12 * length(whole) * static_cast<double>(ring.size());
    double sum = 0.0;
    std::set<std::pair<std::size_t, std::size_t>> sides;
    for (const auto& t : triangles) {
        const Vector<Scene> area = twice_area(ring[t[0]], ring[t[1]], ring[t[2]]);
        sum += length(area);
        EXPECT_GT(dot(area, whole), -tolerance * length(whole)) << "a triangle runs the other way";
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_TRUE(sides.emplace(t[k], t[(k + 1) % 3]).second) << "two triangles on one side of a side";
    }
    // As much as the ring encloses, and all of it in one direction: no triangle is over another.
    EXPECT_NEAR(sum, length(whole), tolerance);
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t next = (i + 1) % ring.size();
        EXPECT_TRUE(sides.contains({i, next})) << "side " << i;
        EXPECT_FALSE(sides.contains({next, i})) << "outside of side " << i;
    }
}

Polygon reversed(Polygon ring) {
    std::ranges::reverse(ring);
    return ring;
}

const Polygon kSquare = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(TriangulatePolygon, TilesSimpleShapes) {
    const std::vector<Polygon> shapes = {
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
        kSquare,
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}},                                             // a dart
        {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 3, 0}}  // a C
    };
    for (const Polygon& shape : shapes) {
        expect_tiles(shape);
        expect_tiles(reversed(shape));
    }
}

TEST(TriangulatePolygon, KeepsCornersInTheMiddleOfAStraightSide) {
    expect_tiles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}});
    expect_tiles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 1, 0}});
    // As near to the middle of an inclined side as doubles come.
    expect_tiles({{0, 0, 0}, {0.1, 0.3, 0}, {0.2, 0.6, 0}, {0.3, 0.9, 0}, {-1, 0.5, 0}});
}

TEST(TriangulatePolygon, WorksInPlanesOfAnyDirectionAndFarFromTheOrigin) {
    const Polygon flat = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {-1, 3, 0}};
    for (const Vector<Scene>& normal : {Vector<Scene>{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {1, 1, 1}, {-1, 2, 1e-9}}) {
        const Vector<Scene> z = normalized(normal);
        const Vector<Scene> x = normalized(cross(z, Vector<Scene>{0.3, 0.5, 0.7}));
        Polygon tilted;
        for (const Point<Scene>& p : flat) tilted.push_back(Point<Scene>{1e6, -2e6, 3e5} + p.x * x + p.y * cross(z, x));
        ASSERT_EQ(polygon_fault(tilted), std::nullopt);
        EXPECT_EQ(triangulate_polygon(tilted).size(), 3U);
    }
}

TEST(TriangulatePolygon, TilesRandomStarsOfManyCorners) {
    constexpr unsigned kSeed = 1991;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> radius(0.05, 1.0);
    for (std::size_t k = 0; k < 2000; ++k) {
        const std::size_t n = 3 + k % 60;
        Polygon star;
        for (std::size_t i = 0; i < n; ++i) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
            const double r = radius(random);
            star.push_back({r * std::cos(angle), r * std::sin(angle), 0.0});
        }
        expect_tiles(k % 2 == 0 ? star : reversed(star));
        ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << kSeed << ", star " << k;
    }
}

// Corners of a small lattice: many in line, many sides parallel, some rings that touch themselves.
TEST(TriangulatePolygon, TilesEveryLatticeRingThatItDoesNotRefuse) {
    constexpr unsigned kSeed = 2024;
    std::mt19937 random(kSeed);
    std::uniform_int_distribution<int> coordinate(0, 5);
    std::size_t tiled = 0, refused = 0;
    for (int k = 0; k < 20'000; ++k) {
        Polygon ring;
        for (int i = 0; i < 3 + k % 6; ++i)
            ring.push_back({static_cast<double>(coordinate(random)), static_cast<double>(coordinate(random)), 0.0});
        if (polygon_fault(ring)) {
            ++refused;
            continue;
        }
        ++tiled;
        expect_tiles(ring);
        ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << kSeed << ", ring " << k;
    }
    EXPECT_GT(tiled, 4000U);
    EXPECT_GT(refused, 4000U);
}

TEST(TriangulateUneven, CutsWhatIsNotFlat) {
    const Polygon saddle = {{0, 0, 0}, {1, 0, 0.3}, {1, 1, 0}, {0, 1, 0.3}};
    ASSERT_TRUE(polygon_fault(saddle).has_value());
    EXPECT_EQ(triangulate_uneven(saddle)->size(), 2U);
    EXPECT_EQ(triangulate_uneven(kSquare), triangulate_polygon(kSquare));
}

TEST(TriangulateUneven, LeavesRepeatedCornersOut) {
    const Polygon ring = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}};
    const auto triangles = triangulate_uneven(ring);
    ASSERT_TRUE(triangles.has_value());
    ASSERT_EQ(triangles->size(), 2U);
    double sum = 0.0;
    for (const auto& t : *triangles) sum += twice_area(ring[t[0]], ring[t[1]], ring[t[2]]).z;
    EXPECT_EQ(sum, 2.0);
}

TEST(TriangulateUneven, RefusesWhatHasNoAreaOrCrosses) {
    const std::vector<Polygon> rings = {{},
                                        {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                                        {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}},
                                        {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}},
                                        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
                                        // Two corners that are one as seen across the plane.
                                        {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {9, 9, 1}, {0, 9, 0}}};
    for (const Polygon& ring : rings) EXPECT_EQ(triangulate_uneven(ring), std::nullopt);
}

TEST(PolygonFault, NamesWhatIsNoPolygon) {
    EXPECT_EQ(polygon_fault(kSquare), std::nullopt);
    EXPECT_EQ(polygon_fault(std::vector<Point<Scene>>{{0, 0, 0}, {1, 0, 0}}), "2 corners, allowed at least 3");
    EXPECT_EQ(polygon_fault(Polygon{}), "0 corners, allowed at least 3");
    EXPECT_EQ(polygon_fault(Polygon{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}}),
              "corners 0 and 3 at the same point, allowed different ones (the last is joined to the first)");
    EXPECT_EQ(polygon_fault(Polygon{{0, 0, 0}, {0, 0, -0.0}, {1, 1, 0}}),
              "corners 0 and 1 at the same point, allowed different ones (the last is joined to the first)");
    EXPECT_EQ(polygon_fault(Polygon{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}}),
              "corners on one line, allowed what has an area");
}

TEST(PolygonFault, AllowsCornersSlightlyOffThePlane) {
    Polygon ring = kSquare;
    // The plane of the corners 0, 2 and 3 has corner 1 to one side: half of what that is off it counts.
    const double diagonal = std::sqrt(2.0);
    ring[3].z = 1.98 * kPlanar * diagonal;
    EXPECT_EQ(polygon_fault(ring), std::nullopt);
    ring[3].z = 2.02 * kPlanar * diagonal;
    EXPECT_EQ(polygon_fault(ring),
              "corners up to 0.0001428 m off one plane (corner 1 is), allowed 0.0001414 m, 0.0001 of its size");
    // The same shape a thousand times as large.
    for (Point<Scene>& p : ring) p = {1000 * p.x, 1000 * p.y, 1000 * p.z};
    EXPECT_EQ(polygon_fault(ring),
              "corners up to 0.1428 m off one plane (corner 1 is), allowed 0.1414 m, 0.0001 of its size");
}

TEST(PolygonFault, NamesACrossing) {
    const std::string crosses = "sides that cross or touch near corner ";
    // An 8 whose two halves have the same area, a side through a corner, a corner on a side, sides upon each other.
    const std::vector<Polygon> rings = {{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},
                                        {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0, 0}, {0, 2, 0}},
                                        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {0, 4, 0}},
                                        {{0, 0, 0}, {3, 0, 0}, {1, 0, 0}, {1, 1, 0}}};
    for (const Polygon& ring : rings) {
        for (const Polygon& way : {ring, reversed(ring)}) {
            const auto fault = polygon_fault(way);
            ASSERT_TRUE(fault.has_value());
            EXPECT_TRUE(fault->starts_with(crosses)) << *fault;
        }
    }
    EXPECT_EQ(polygon_fault(Polygon{{0, 0, 0}, {10, 0, 0}, {10, 9, 0}, {9.9, -1, 0}, {0, 5, 0}}),
              crosses + "1, allowed a ring that keeps clear of itself");
}

}  // namespace
}  // namespace overfly
