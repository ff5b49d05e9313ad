#include "shot/prepare_scene.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/error.h"
#include "core/stopwatch.h"
#include "io/elevation_file.h"
#include "io/elevation_inputs.h"
#include "io/temporary_file.h"
#include "terrain/triangulate.h"

namespace overfly {
namespace {

// Raised when the same inputs make another scene.
constexpr int kMeshingVersion = 1;

std::string settings_of(const ElevationSource& source) {
    return fmt::format("meshing {} band {} crs {} no_data {} unit {} datum {} offset {}", kMeshingVersion,
                       source.band ? std::to_string(*source.band) : "-", source.crs,
                       source.no_data ? fmt::format("{}", *source.no_data) : "-", source.vertical_unit,
                       static_cast<int>(source.vertical_datum), source.vertical_offset_m);
}

PreparedScene prepare(const ElevationSource& source, const Progress& progress) {
    const auto say = [&](const char* what) {
        if (progress) progress(what, 0.0, 0.0);
    };
    say("reading elevation");
    const ElevationFile elevation = read_elevation(source);
    say("triangulating");
    PreparedScene scene;
    scene.origin = {elevation.centre.lon, elevation.centre.lat, 0.0};
    scene.report = elevation.report;
    scene.mesh = triangulate(*elevation.model, SceneFrame(scene.origin), elevation.locate);
    if (scene.mesh.triangles.empty()) {
        throw UserError({source.dem.front()},
                        "no cell of the raster has three measured corners, so there is no ground");
    }
    return scene;
}

}  // namespace

std::filesystem::path default_cache_folder() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0') {
        return std::filesystem::path(cache) / "overfly";
    }
    if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0') {
        return std::filesystem::path(home) / ".cache" / "overfly";
    }
    return std::filesystem::temp_directory_path() / "overfly-cache";
}

std::filesystem::path cached_scene_file(const std::filesystem::path& cache_folder, const std::string& hash) {
    return cache_folder / "scenes" / (hash + ".scene");
}

void try_to_save_scene(const std::filesystem::path& file, const PreparedScene& scene) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error) return;
    remove_abandoned_files(file.parent_path());
    try {
        save_scene(file, scene);
    } catch (const UserError&) {
        // Promised in the header: without a cache the work is done again next time.
        return;
    }
}

PreparedTerrain prepare_terrain(const TerrainDocument& document, const std::filesystem::path& cache_folder,
                                const Progress& progress) {
    const Stopwatch watch;
    const std::vector<std::filesystem::path> inputs = elevation_inputs(document.source);
    PreparedTerrain terrain;
    terrain.inputs = hashed_files(inputs);
    const std::string hash = content_hash_of(terrain.inputs, settings_of(document.source));
    const std::filesystem::path file = cached_scene_file(cache_folder, hash);
    if (auto scene = load_scene(file); scene && scene->content_hash == hash) {
        terrain.scene = std::move(*scene);
        terrain.scene.report.files = inputs;  // the same content may have another name by now
        terrain.from_cache = true;
    } else {
        terrain.scene = prepare(document.source, progress);
        terrain.scene.content_hash = hash;
        try_to_save_scene(file, terrain.scene);
    }
    terrain.seconds = watch.seconds();
    return terrain;
}

}  // namespace overfly
