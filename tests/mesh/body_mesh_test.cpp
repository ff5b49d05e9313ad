#include "mesh/body_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/mesh_plane.h"

namespace overfly {
namespace {

using Ids = std::array<VertexId, 3>;
using Twins = std::array<HalfEdgeId, 3>;

TEST(BodyMesh, JoinsEqualPositionsAndConnects) {
    // Two triangles of a square, each with corners of its own.
    const std::vector<Point<Scene>> positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, -0.0, 0}, {1, 1, 0}, {0, 1, 0}};
    const BodyMesh body = body_mesh_of(positions, std::vector<Ids>{{0, 1, 2}, {3, 4, 5}});
    EXPECT_EQ(body.mesh.positions, (std::vector<Point<Scene>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(body.mesh.triangles, (std::vector<Ids>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(body.mesh.twins, (std::vector<Twins>{{kNone, kNone, 4}, {2, kNone, kNone}}));
    EXPECT_EQ(body.dropped_degenerate, 0U);
}

TEST(BodyMesh, DoesNotJoinWhatIsOnlyNear) {
    const double near_1 = std::nextafter(1.0, 2.0);
    const std::vector<Point<Scene>> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {near_1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const BodyMesh body = body_mesh_of(positions, std::vector<Ids>{{0, 1, 2}, {3, 4, 5}});
    EXPECT_EQ(body.mesh.positions.size(), 5U);
}

TEST(BodyMesh, DropsAndCountsTrianglesWithoutArea) {
    const std::vector<Point<Scene>> positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {9, 9, 9}, {1, 0, 0}};
    const BodyMesh body = body_mesh_of(positions, std::vector<Ids>{{0, 1, 2}, {0, 1, 3}, {1, 1, 3}, {1, 5, 3}});
    EXPECT_EQ(body.dropped_degenerate, 3U);
    EXPECT_EQ(body.mesh.triangles, (std::vector<Ids>{{0, 1, 2}}));
    // And the positions that nobody needs any more.
    EXPECT_EQ(body.mesh.positions, (std::vector<Point<Scene>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(BodyMesh, KeepsThinTriangles) {
    const std::vector<Point<Scene>> positions = {{1e5, 0, 0}, {1e5 + 1, 0, 0}, {1e5, 1e-6, 0}};
    EXPECT_EQ(body_mesh_of(positions, std::vector<Ids>{{0, 1, 2}}).dropped_degenerate, 0U);
}

TEST(BodyMesh, OfPolygonsIsConnectedAcrossTheirSides) {
    // Three faces of a cube around one corner.
    const std::vector<Polygon> faces = {{{0, 0, 0}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}},
                                        {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}},
                                        {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}}};
    const BodyMesh body = body_mesh_of(faces);
    EXPECT_EQ(body.mesh.positions.size(), 7U);
    EXPECT_EQ(body.mesh.triangles.size(), 6U);
    int borders = 0;
    for (const Twins& twins : body.mesh.twins)
        for (const HalfEdgeId twin : twins) borders += twin == kNone ? 1 : 0;
    EXPECT_EQ(borders, 6);
}

TEST(MeshPlane, FindsThePlaneWhicheverWayTheTrianglesRun) {
    const std::vector<Polygon> faces = {{{0, 0, 5}, {1, 0, 5}, {0, 2, 5}}, {{1, 0, 5}, {0, 2, 5}, {1, 2, 5}}};
    const MeshPlane plane = plane_of(body_mesh_of(faces).mesh);
    EXPECT_NEAR(std::abs(plane.normal.z), 1.0, 1e-15);
    EXPECT_EQ(plane.on.z, 5.0);
    EXPECT_EQ(plane.farthest_m, 0.0);
    EXPECT_NEAR(plane.size_m, std::sqrt(5.0), 1e-15);
    EXPECT_TRUE(plane.is_planar());
}

TEST(MeshPlane, SaysHowFarFromPlanarAMeshIs) {
    // A roof: the ridge is 1 m higher than the eaves.
    const std::vector<Polygon> roof = {{{-3, 0, 0}, {3, 0, 0}, {3, 4, 1}, {-3, 4, 1}},
                                       {{-3, 8, 0}, {-3, 4, 1}, {3, 4, 1}, {3, 8, 0}}};
    const MeshPlane plane = plane_of(body_mesh_of(roof).mesh);
    EXPECT_NEAR(std::abs(plane.normal.z), 1.0, 1e-15);
    EXPECT_NEAR(plane.on.z, 1.0 / 3.0, 1e-15);
    EXPECT_NEAR(plane.farthest_m, 2.0 / 3.0, 1e-15);
    EXPECT_FALSE(plane.is_planar());
}

}  // namespace
}  // namespace overfly
