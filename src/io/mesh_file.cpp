#include "io/mesh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <variant>

#include <assimp/DefaultIOSystem.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

#include "core/error.h"
#include "flight/resolve_place.h"
#include "io/ply_header.h"

namespace overfly {
namespace {

// Farther out a body would be larger than the Earth, and single precision coarser than a metre.
constexpr double kFarthest_m = 1e7;

// A face is more than one triangle as a rule, and there are numbers for 2^30.
constexpr std::size_t kMostFaces = 250'000'000;

// Reads files as assimp does by itself, and notes which.
class NotingFiles : public Assimp::DefaultIOSystem {
  public:
    explicit NotingFiles(std::vector<std::filesystem::path>& files) : files_(files) {}

    Assimp::IOStream* Open(const char* file, const char* mode) override {
        Assimp::IOStream* stream = DefaultIOSystem::Open(file, mode);
        if (stream != nullptr && std::ranges::find(files_, file) == files_.end()) files_.emplace_back(file);
        return stream;
    }

  private:
    std::vector<std::filesystem::path>& files_;
};

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
    throw UserError({file}, "can't be used as a mesh: " + why);
}

std::string on_one_line(std::string text) {
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
    return text;
}

// The scene belongs to the importer.
const aiScene& import(Assimp::Importer& importer, const std::filesystem::path& file) {
    const std::optional<MeshFormat> format = mesh_format(file);
    if (!format) refuse(file, fmt::format("allowed {}", kMeshFileNames));
    if (format == MeshFormat::Ply) {
        if (const auto fault = ply_header_fault(file)) refuse(file, on_one_line(*fault));
    }
    if (const aiScene* scene = importer.ReadFile(file.string(), 0)) return *scene;
    const std::string reason = importer.GetErrorString();
    refuse(file, reason.empty() ? "it is broken" : on_one_line(reason));
}

// The upper three rows of a node's matrix, in double.
struct Affine {
    std::array<std::array<double, 4>, 3> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

    [[nodiscard]] Point<Scene> operator*(Point<Scene> p) const {
        const auto along = [&](const std::array<double, 4>& r) { return r[0] * p.x + r[1] * p.y + r[2] * p.z + r[3]; };
        return {along(rows[0]), along(rows[1]), along(rows[2])};
    }
    [[nodiscard]] bool is_mirrored() const {
        const auto row = [&](std::size_t i) { return Vector<Scene>{rows[i][0], rows[i][1], rows[i][2]}; };
        return dot(cross(row(0), row(1)), row(2)) < 0.0;
    }
};

Affine inside(const Affine& outer, const aiMatrix4x4& inner) {
    Affine product;
    for (std::size_t i = 0; i < 3; ++i) {
        for (unsigned j = 0; j < 4; ++j) {
            double sum = j == 3 ? outer.rows[i][3] : 0.0;
            for (unsigned k = 0; k < 3; ++k) sum += outer.rows[i][k] * static_cast<double>(inner[k][j]);
            product.rows[i][j] = sum;
        }
    }
    return product;
}

// What the nodes of a file place, as loose faces.
struct Surfaces {
    std::vector<Point<Scene>> positions;
    std::vector<std::vector<VertexId>> faces;
    std::size_t points_and_lines = 0;

    void add(const aiMesh& mesh, const Affine& placed) {
        const auto base = static_cast<VertexId>(positions.size());
        for (const aiVector3D& v : std::span(mesh.mVertices, mesh.mNumVertices))
            positions.push_back(placed * Point<Scene>{v.x, v.y, v.z});
        for (const aiFace& face : std::span(mesh.mFaces, mesh.mNumFaces)) {
            if (face.mNumIndices < 3) {
                ++points_and_lines;
                continue;
            }
            std::vector<VertexId>& corners = faces.emplace_back();
            for (const unsigned v : std::span(face.mIndices, face.mNumIndices)) corners.push_back(base + v);
            // So that a surface and its mirror image have the same outside.
            if (placed.is_mirrored()) std::ranges::reverse(corners);
        }
    }

    void add(const aiScene& scene, const aiNode& node, const Affine& outer) {
        const Affine placed = inside(outer, node.mTransformation);
        for (const unsigned mesh : std::span(node.mMeshes, node.mNumMeshes)) add(*scene.mMeshes[mesh], placed);
        for (const aiNode* child : std::span(node.mChildren, node.mNumChildren)) add(scene, *child, placed);
    }
};

Surfaces surfaces_of(const std::filesystem::path& file) {
    Assimp::Importer importer;
    const aiScene& scene = import(importer, file);
    Surfaces surfaces;
    std::size_t corners = 0;
    for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) corners += mesh->mNumVertices;
    surfaces.positions.reserve(corners);
    if (scene.mRootNode != nullptr) surfaces.add(scene, *scene.mRootNode, Affine{});
    return surfaces;
}

Point<Scene> upright(Point<Scene> p, const MeshSource& source) {
    const Point<Scene> up = source.up == UpAxis::Z ? p : Point<Scene>{-p.x, p.z, p.y};
    return {source.scale * up.x, source.scale * up.y, source.scale * up.z};
}

// Cuts the faces into triangles: what is one already stays as it is.
BodyMesh body_mesh_of(const Surfaces& surfaces) {
    std::vector<std::array<VertexId, 3>> triangles;
    std::size_t without_area = 0;
    std::vector<Point<Scene>> corners;
    for (const std::vector<VertexId>& face : surfaces.faces) {
        if (face.size() == 3) {
            triangles.push_back({face[0], face[1], face[2]});
            continue;
        }
        corners.clear();
        for (const VertexId v : face) corners.push_back(surfaces.positions[v]);
        const auto parts = triangulate_uneven(corners);
        if (!parts) {
            ++without_area;
            continue;
        }
        for (const auto& [a, b, c] : *parts) triangles.push_back({face[a], face[b], face[c]});
    }
    BodyMesh body = body_mesh_of(surfaces.positions, triangles);
    body.dropped_degenerate += without_area;
    body.skipped_other = surfaces.points_and_lines;
    return body;
}

bool is_near(Point<Scene> p) {
    // A comparison with what is not a number is false.
    return std::abs(p.x) <= kFarthest_m && std::abs(p.y) <= kFarthest_m && std::abs(p.z) <= kFarthest_m;
}

}  // namespace

BodyMesh read_mesh_file(const MeshSource& source) {
    Surfaces surfaces = surfaces_of(source.file);
    for (Point<Scene>& p : surfaces.positions) p = upright(p, source);
    const auto bad = std::ranges::count_if(surfaces.positions, [](Point<Scene> p) { return !is_near(p); });
    if (bad > 0) {
        refuse(source.file,
               fmt::format("{} of its {} positions are not finite or farther than 10,000 km from the middle", bad,
                           surfaces.positions.size()));
    }
    if (surfaces.faces.size() >= kMostFaces)
        refuse(source.file, fmt::format("{} faces, allowed fewer than {}", surfaces.faces.size(), kMostFaces));
    BodyMesh body = body_mesh_of(surfaces);
    if (body.mesh.triangles.empty()) {
        refuse(source.file,
               fmt::format("no surfaces in it ({} without area or that cross themselves, {} points and lines)",
                           body.dropped_degenerate, body.skipped_other));
    }
    return body;
}

BodyMesh read_body_mesh(const BodyShape& shape, const BodyMotion& motion, const Surroundings& surroundings) {
    if (const auto* source = std::get_if<MeshSource>(&shape)) return read_mesh_file(*source);
    if (const auto* polygons = std::get_if<std::vector<Polygon>>(&shape)) return body_mesh_of(*polygons);
    const auto* rest = std::get_if<BodyPolynomials>(&motion);
    check(rest != nullptr, "an outline's body is at rest");
    const std::optional<Geodetic> middle = resolve_place(rest->place, surroundings);
    check(middle.has_value(), "an outline's height is counted from ground that is there");
    return body_mesh_of(std::array{level_polygon(std::get<Outline>(shape), *middle)});
}

std::vector<std::filesystem::path> mesh_file_inputs(const std::filesystem::path& file) {
    std::vector<std::filesystem::path> files = {file};
    Assimp::Importer importer;
    importer.SetIOHandler(new NotingFiles(files));  // assimp deletes it
    (void)import(importer, file);
    return files;
}

}  // namespace overfly
