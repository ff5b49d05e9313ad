#include "io/mesh_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <random>

#include "core/error.h"
#include "io/temporary_folder.h"

// Asked by the leak sanitizer: assimp 5.2 forgets memory of its own where it gives up on a broken PLY file.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp.so\n"; }

namespace overfly {
namespace {

using Ids = std::array<VertexId, 3>;
using Positions = std::vector<Point<Scene>>;

class MeshFile : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }

    // What the program says of a file, behind its name.
    std::string refusal(const std::string& name, const std::string& text) const {
        const std::filesystem::path file = write(name, text);
        try {
            (void)read_mesh_file({file});
        } catch (const UserError& e) {
            EXPECT_EQ(e.problems().size(), 1U);
            EXPECT_EQ(e.problems()[0].place.file, file);
            EXPECT_EQ(e.problems()[0].message.find('\n'), std::string::npos);
            return e.problems()[0].message;
        }
        return "no error";
    }

    TemporaryFolder folder_;
};

// A square in a text PLY, as one polygon.
const std::string kSquarePly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 1\n2 0 1\n2 3 1\n0 3 1\n4 0 1 2 3\n";

double area_m2(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        sum += 0.5 * length(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]));
    return sum;
}

std::size_t borders(const TriangleMesh& mesh) {
    std::size_t count = 0;
    for (const auto& twins : mesh.twins) count += static_cast<std::size_t>(std::ranges::count(twins, kNone));
    return count;
}

bool holds(const TriangleMesh& mesh, Point<Scene> p) {
    return std::ranges::find(mesh.positions, p) != mesh.positions.end();
}

TEST_F(MeshFile, OfPlyIsRead) {
    const BodyMesh body = read_mesh_file({write("a.ply", kSquarePly)});
    EXPECT_EQ(body.mesh.positions, (Positions{{0, 0, 1}, {2, 0, 1}, {2, 3, 1}, {0, 3, 1}}));
    EXPECT_EQ(body.mesh.triangles.size(), 2U);
    EXPECT_EQ(area_m2(body.mesh), 6.0);
    EXPECT_EQ(borders(body.mesh), 4U);
    EXPECT_EQ(body.dropped_degenerate + body.skipped_other, 0U);
}

TEST_F(MeshFile, IsScaledAndTurnedUpright) {
    const auto file = write("a.obj", "v 1 2 4\nv 2 2 4\nv 1 3 4\nf 1 2 3\n");
    const BodyMesh z_up = read_mesh_file({file, 0.5, UpAxis::Z});
    EXPECT_EQ(z_up.mesh.positions, (Positions{{0.5, 1, 2}, {1, 1, 2}, {0.5, 1.5, 2}}));
    const BodyMesh y_up = read_mesh_file({file, 0.5, UpAxis::Y});
    EXPECT_EQ(y_up.mesh.positions, (Positions{{-0.5, 2, 1}, {-1, 2, 1}, {-0.5, 2, 1.5}}));
    // In double: a tenth of a float is not a float.
    EXPECT_EQ(read_mesh_file({file, 0.1, UpAxis::Z}).mesh.positions[0].x, 0.1 * 1.0);
}

TEST_F(MeshFile, OfObjJoinsItsObjectsAndForgetsNormalsAndTextures) {
    // Two squares of a box's corner, in two objects and two materials, with normals of their own; concave and with
    // five corners is the second.
    const std::string text =
        "mtllib a.mtl\no left\nusemtl red\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\n"
        "f 1/1/1 2/1/1 3/1/1 4/1/1\no right\nusemtl blue\nv 0 0 0\nv 0 0 1\nv 0 0.5 0.5\nv 0 1 1\nv 0 1 0\nvn 1 0 0\n"
        "f 9/1/2 8/1/2 7/1/2 6/1/2 5/1/2\n";
    write("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    const BodyMesh body = read_mesh_file({write("a.obj", text)});
    EXPECT_EQ(body.mesh.positions.size(), 7U);
    EXPECT_EQ(body.mesh.triangles.size(), 5U);
    EXPECT_EQ(borders(body.mesh), 7U);  // 4 + 5 sides, one shared
    EXPECT_NEAR(area_m2(body.mesh), 1.75, 1e-12);
}

TEST_F(MeshFile, SkipsPointsAndLinesAndDropsWhatHasNoArea) {
    const BodyMesh body =
        read_mesh_file({write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nl 1 2\nf 1 2 3\nf 1 2 4\nf 1 2 2\np 4\n")});
    EXPECT_EQ(body.mesh.triangles, (std::vector<Ids>{{0, 1, 2}}));
    EXPECT_EQ(body.mesh.positions.size(), 3U);
    EXPECT_EQ(body.dropped_degenerate, 2U);
    EXPECT_EQ(body.skipped_other, 2U);
}

std::string bytes_of(std::initializer_list<float> numbers) {
    std::string bytes;
    for (const float number : numbers) {
        const auto bits = std::bit_cast<std::uint32_t>(number);
        for (unsigned k = 0; k < 4; ++k) bytes.push_back(static_cast<char>(bits >> (8 * k) & 0xFFU));
    }
    return bytes;
}

// One triangle, placed twice: moved by (10, 0, 0), and mirrored in x and scaled by 2 inside a node moved by (0, 0, 5).
std::string gltf(const std::string& buffer) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],)"
           R"("nodes":[{"mesh":0,"translation":[10,0,0]},{"translation":[0,0,5],"children":[2]},)"
           R"({"mesh":0,"scale":[-2,2,2]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
           R"("buffers":[{)" +
           buffer +
           R"("byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,)"
           R"("componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})";
}

const std::initializer_list<float> kTriangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};

void expect_both_triangles(const MeshSource& source) {
    const TriangleMesh mesh = read_mesh_file(source).mesh;
    ASSERT_EQ(mesh.triangles.size(), 2U);
    // With Y up: (x, y, z) of the file is (-x, z, y) of the body.
    for (const Point<Scene>& p : {Point<Scene>{-10, 0, 0}, {-11, 0, 0}, {-10, 0, 1}, {0, 5, 0}, {2, 5, 0}, {0, 5, 2}})
        EXPECT_TRUE(holds(mesh, p)) << p.x << ' ' << p.y << ' ' << p.z;
    // The outside is the same for both, though one is a mirror image: along the file's z, which is forward.
    for (const auto& [a, b, c] : mesh.triangles)
        EXPECT_GT(cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).y, 0.0);
}

TEST_F(MeshFile, CutsPolygonsThatAreUnevenOrRepeatACorner) {
    // A quadrilateral that is not quite flat, one that repeats a corner, one that crosses itself.
    const BodyMesh body = read_mesh_file(
        {write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.2\nv 0 1 0\nv 3 0 0\nf 1 2 3 4\nf 2 5 5 3\nf 1 3 2 4\n")});
    EXPECT_EQ(body.mesh.triangles.size(), 3U);
    EXPECT_EQ(body.dropped_degenerate, 1U);
    EXPECT_EQ(borders(body.mesh), 5U);
}

TEST_F(MeshFile, OfGltfIsPlacedByItsNodes) {
    write("a.bin", bytes_of(kTriangle));
    const auto file = write("a.gltf", gltf(R"("uri":"a.bin",)"));
    expect_both_triangles({file, 1.0, UpAxis::Y});
    const auto inputs = mesh_file_inputs(file);
    ASSERT_EQ(inputs.size(), 2U);
    EXPECT_EQ(inputs[0], file);
    EXPECT_EQ(inputs[1].filename(), "a.bin");
    EXPECT_TRUE(std::filesystem::equivalent(inputs[1], folder_ / "a.bin"));
}

TEST_F(MeshFile, OfGlbIsPlacedByItsNodes) {
    const auto word = [](std::size_t n) {
        std::string bytes;
        for (unsigned k = 0; k < 4; ++k) bytes.push_back(static_cast<char>(n >> (8 * k) & 0xFFU));
        return bytes;
    };
    std::string json = gltf("");
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::string numbers = bytes_of(kTriangle);
    const std::string chunks =
        word(json.size()) + "JSON" + json + word(numbers.size()) + std::string("BIN\0", 4) + numbers;
    const auto file = write("a.glb", "glTF" + word(2) + word(12 + chunks.size()) + chunks);
    expect_both_triangles({file, 1.0, UpAxis::Y});
    EXPECT_EQ(mesh_file_inputs(file), std::vector{file});
}

TEST_F(MeshFile, IsRefusedWithTheReason) {
    const std::string cant = "can't be used as a mesh: ";
    EXPECT_EQ(refusal("a.stl", "solid a\nendsolid a\n"), cant + "allowed a file called .ply, .obj, .gltf or .glb");
    for (const char* name : {"empty.ply", "empty.obj", "empty.gltf", "empty.glb"}) {
        const std::string said = refusal(name, "");
        EXPECT_TRUE(said.starts_with(cant) && said.size() > cant.size() + 5) << name << ": " << said;
    }
    for (const char* name : {"noise.ply", "noise.gltf", "noise.glb"}) {
        const std::string said = refusal(name, std::string(1000, '\x7F'));
        EXPECT_TRUE(said.starts_with(cant) && said.size() > cant.size() + 5) << name << ": " << said;
    }
    EXPECT_EQ(refusal("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nl 1 2 3\nf 1 2 3\n"),
              cant + "no surfaces in it (1 without area or that cross themselves, 2 points and lines)");
    EXPECT_EQ(refusal("endless.ply", kSquarePly.substr(0, kSquarePly.find("end_header"))),
              cant + "its header has no end ('end_header')");
    std::string many = kSquarePly;
    EXPECT_EQ(refusal("many.ply", many.replace(many.find("vertex 4"), 8, "vertex 4000000000")),
              cant + "it can't have the elements of 'element vertex 4000000000'");
    const std::string only_points =
        refusal("cloud.ply",
                "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n0 0 0\n1 1 1\n");
    EXPECT_TRUE(only_points.starts_with(cant)) << only_points;
}

TEST_F(MeshFile, WithPositionsThatAreNotFiniteOrFarAwayIsRefused) {
    const std::string said =
        "can't be used as a mesh: 1 of its 3 positions are not finite or farther than 10,000 km from the middle";
    EXPECT_EQ(refusal("nan.obj", "v 0 0 0\nv 1 nan 0\nv 0 1 0\nf 1 2 3\n"), said);
    EXPECT_EQ(refusal("inf.obj", "v 0 0 0\nv 1 -inf 0\nv 0 1 0\nf 1 2 3\n"), said);
    EXPECT_EQ(refusal("far.obj", "v 0 0 0\nv 1e8 1e7 0\nv 0 1e7 0\nf 1 2 3\n"), said);
    // In metres, not in the file's unit.
    EXPECT_EQ(read_mesh_file({folder_ / "far.obj", 0.01}).mesh.triangles.size(), 1U);
}

TEST_F(MeshFile, ThatIsNotThereIsRefused) {
    for (const auto& file : {folder_ / "nowhere.ply", folder_.path()})
        EXPECT_THROW((void)read_mesh_file({file}), UserError) << file;
    EXPECT_THROW((void)mesh_file_inputs(folder_ / "nowhere.ply"), UserError);
    // Nor without the file that holds its numbers.
    EXPECT_TRUE(refusal("b.gltf", gltf(R"("uri":"gone.bin",)")).starts_with("can't be used as a mesh: "));
}

TEST_F(MeshFile, ChangedAtRandomIsReadOrRefused) {
    constexpr unsigned kSeed = 7;
    std::mt19937 random(kSeed);
    std::uniform_int_distribution<int> byte(32, 126);
    int read = 0, refused = 0;
    for (int i = 0; i < 400; ++i) {
        std::string text = kSquarePly;
        for (int edits = 1 + i % 3; edits > 0; --edits)
            text[std::uniform_int_distribution<std::size_t>(0, text.size() - 1)(random)] =
                static_cast<char>(byte(random));
        try {
            const BodyMesh body = read_mesh_file({write("m.ply", text)});
            for (const Point<Scene>& p : body.mesh.positions) ASSERT_TRUE(std::isfinite(p.x + p.y + p.z));
            ++read;
        } catch (const UserError&) {
            ++refused;
        }
    }
    EXPECT_GT(read, 20) << "seed " << kSeed;
    EXPECT_GT(refused, 20) << "seed " << kSeed;
}

TEST(BodyMeshOf, EveryShape) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a.ply") << kSquarePly;
    const Surroundings hills{[](Angle, Angle) { return 1200.0; }, [](Angle, Angle) { return -20.0; }, {}};
    EXPECT_EQ(read_body_mesh(MeshSource{folder / "a.ply"}, BodyPolynomials{}, hills).mesh,
              read_mesh_file({folder / "a.ply"}).mesh);
    const std::vector<Polygon> polygons = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}};
    EXPECT_EQ(read_body_mesh(polygons, BodyFlight{}, hills).mesh, body_mesh_of(polygons).mesh);

    const Outline lake = {{Angle::degrees(7.0), Angle::degrees(46.0)},
                          {Angle::degrees(7.1), Angle::degrees(46.0)},
                          {Angle::degrees(7.0), Angle::degrees(46.1)}};
    BodyPolynomials rest;
    const LonLat middle = middle_of(lake);
    rest.place = {middle.lon, middle.lat, 5.0, HeightAbove::Ground};
    const std::vector<Polygon> level = {level_polygon(lake, {middle.lon, middle.lat, 1205.0})};
    EXPECT_EQ(read_body_mesh(lake, rest, hills).mesh, body_mesh_of(level).mesh);
}

}  // namespace
}  // namespace overfly
