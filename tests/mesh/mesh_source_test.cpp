#include "mesh/mesh_source.h"

#include <gtest/gtest.h>

namespace overfly {
namespace {

TEST(MeshSource, KnowsFormatsByTheEndOfTheName) {
    EXPECT_EQ(mesh_format("a/b.ply"), MeshFormat::Ply);
    EXPECT_EQ(mesh_format("a.b.OBJ"), MeshFormat::Obj);
    EXPECT_EQ(mesh_format("a.gltf"), MeshFormat::Gltf);
    EXPECT_EQ(mesh_format("a.glb"), MeshFormat::Gltf);
    EXPECT_EQ(mesh_format("a.stl"), std::nullopt);
    EXPECT_EQ(mesh_format("ply"), std::nullopt);
}

TEST(MeshSource, TakesYForUpInGltfOnly) {
    EXPECT_EQ(usual_up_axis(MeshFormat::Gltf), UpAxis::Y);
    EXPECT_EQ(usual_up_axis(MeshFormat::Obj), UpAxis::Z);
    EXPECT_EQ(usual_up_axis(MeshFormat::Ply), UpAxis::Z);
}

}  // namespace
}  // namespace overfly
