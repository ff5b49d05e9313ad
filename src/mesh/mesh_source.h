#pragma once

#include <filesystem>
#include <optional>

namespace overfly {

// Which axis of a mesh file points up.
enum class UpAxis { Y, Z };

// A mesh in a file, and how it becomes a body. With Z up the body's axes are the file's: x to the right, y forward.
// With Y up the nose points along the file's z, as in glTF (3.4 of its specification): the body's x, y, z are the
// file's -x, z, y.
struct MeshSource {
    std::filesystem::path file;
    double scale = 1.0;  // metres in the file's unit
    UpAxis up = UpAxis::Z;

    friend bool operator==(const MeshSource&, const MeshSource&) = default;
};

// The formats that are read, known by the end of the file's name, in capitals or not.
enum class MeshFormat { Ply, Obj, Gltf };
inline constexpr const char* kMeshFileNames = "a file called .ply, .obj, .gltf or .glb";
[[nodiscard]] std::optional<MeshFormat> mesh_format(const std::filesystem::path& file);

// What up is where nobody says: Y in glTF, where it is laid down, Z in the others.
[[nodiscard]] UpAxis usual_up_axis(MeshFormat format);

}  // namespace overfly
