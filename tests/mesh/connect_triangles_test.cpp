#include "mesh/connect_triangles.h"

#include <gtest/gtest.h>

#include "support/terrains.h"

namespace overfly {
namespace {

TEST(ConnectTriangles, FindsTheTwinsOfASheet) {
    const TerrainMesh sheet = testing::heightfield(9, 7, 10.0, testing::rough_ground);
    TriangleMesh mesh = sheet;
    mesh.twins.clear();
    connect_triangles(mesh);
    EXPECT_EQ(mesh.twins, sheet.twins);
}

TEST(ConnectTriangles, LeavesASideThatThreeTrianglesShareWithoutTwins) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    connect_triangles(mesh);
    for (const auto& twins : mesh.twins) EXPECT_EQ(twins, (std::array<HalfEdgeId, 3>{kNone, kNone, kNone}));
}

TEST(ConnectTriangles, LeavesASideThatTwoRunAlongAlikeWithoutTwins) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
    connect_triangles(mesh);
    EXPECT_EQ(mesh.twins[0][0], kNone);
    EXPECT_EQ(mesh.twins[1][0], kNone);
}

}  // namespace
}  // namespace overfly
