#include "mesh/mesh_source.h"

#include <algorithm>
#include <string>

namespace overfly {

std::optional<MeshFormat> mesh_format(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (ending == ".ply") return MeshFormat::Ply;
    if (ending == ".obj") return MeshFormat::Obj;
    if (ending == ".gltf" || ending == ".glb") return MeshFormat::Gltf;
    return std::nullopt;
}

UpAxis usual_up_axis(MeshFormat format) { return format == MeshFormat::Gltf ? UpAxis::Y : UpAxis::Z; }

}  // namespace overfly
