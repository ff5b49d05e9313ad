#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/documents.h"
#include "core/progress.h"
#include "io/content_hash.h"
#include "io/scene_file.h"

namespace overfly {

// Where prepared scenes are kept between runs: $XDG_CACHE_HOME/overfly, else ~/.cache/overfly.
[[nodiscard]] std::filesystem::path default_cache_folder();

// Where in it the scene of a content hash is.
[[nodiscard]] std::filesystem::path cached_scene_file(const std::filesystem::path& cache_folder,
                                                      const std::string& hash);
// A cache that can't be written is not an error: the scene is prepared each time.
void try_to_save_scene(const std::filesystem::path& file, const PreparedScene& scene);

struct PreparedTerrain {
    PreparedScene scene;
    std::vector<HashedFile> inputs;  // all files that it was made from
    bool from_cache = false;
    double seconds = 0.0;
};

// Elevation read, placed on the ellipsoid and meshed; or the same from the cache, if its inputs' contents and all that
// the document says of them have not changed. The scene's origin is the middle of the raster, on the ellipsoid.
[[nodiscard]] PreparedTerrain prepare_terrain(const TerrainDocument& document,
                                              const std::filesystem::path& cache_folder, const Progress& progress = {});

}  // namespace overfly
