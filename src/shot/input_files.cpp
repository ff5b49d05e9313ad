#include "shot/input_files.h"

#include <filesystem>
#include <variant>

#include "io/class_raster.h"
#include "io/mesh_file.h"

namespace overfly {
namespace {

struct NamedFile {
    std::string what;
    std::filesystem::path file;
};

std::vector<NamedFile> named_files(const ShotDocument& shot) {
    std::vector<NamedFile> files = {{"shot", shot.file}, {"terrain", shot.terrain.file}, {"flight", shot.flight.file}};
    for (const BodyDocument& body : shot.bodies) {
        if (!body.flight_file.empty()) files.push_back({"flight of " + body.name, body.flight_file});
        const auto* const mesh = std::get_if<MeshSource>(&body.shape);
        if (mesh == nullptr) continue;
        for (const std::filesystem::path& file : mesh_file_inputs(mesh->file))
            files.push_back({"mesh of " + body.name, file});
    }
    if (!shot.look.colours.empty()) files.push_back({"colours", shot.look.colours});
    if (shot.classes && shot.layers.has_any({Layer::Id, Layer::Cryptomatte})) {
        for (const std::filesystem::path& file : class_raster_inputs(shot.classes->raster))
            files.push_back({"classes", file});
    }
    return files;
}

}  // namespace

std::vector<InputFile> input_files(const ShotDocument& shot, std::span<const HashedFile> elevation) {
    const std::vector<NamedFile> named = named_files(shot);
    std::vector<std::filesystem::path> files;
    for (const NamedFile& n : named) files.push_back(n.file);
    const std::vector<HashedFile> hashed = hashed_files(files);
    std::vector<InputFile> inputs;
    for (std::size_t i = 0; i < named.size(); ++i) inputs.push_back({named[i].what, hashed[i]});
    for (const HashedFile& raster : elevation) inputs.push_back({"elevation", raster});
    return inputs;
}

}  // namespace overfly
