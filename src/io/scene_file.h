#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geo/frames.h"
#include "io/elevation_file.h"
#include "terrain/terrain_mesh.h"

namespace overfly {

// Terrain that is ready to be rendered, kept so that a second run need not read and mesh the elevation again.
struct PreparedScene {
    std::string content_hash;  // of what it was made from (content_hash.h)
    Geodetic origin;
    ElevationReport report;
    TerrainMesh mesh;
    double largest_error_px = 0.0;  // of a mesh that was made for a flight (largest_mesh_error_px); 0 with all samples

    friend bool operator==(const PreparedScene&, const PreparedScene&) = default;
};

// Writes the scene under a temporary name beside `file` and renames it. Throws UserError when it can't be written.
void save_scene(const std::filesystem::path& file, const PreparedScene& scene);

// GUARANTEES: nothing but what save_scene of this version wrote comes back, to the last bit. Without a value: no such
// file, of another version, or damaged; then it is to be prepared anew.
[[nodiscard]] std::optional<PreparedScene> load_scene(const std::filesystem::path& file);

// Its content hash alone, without reading the mesh; what follows the head of the file may be damaged.
[[nodiscard]] std::optional<std::string> scene_content_hash(const std::filesystem::path& file);

}  // namespace overfly
