#pragma once

#include <filesystem>

#include "config/documents.h"
#include "core/progress.h"
#include "io/scene_file.h"

namespace overfly {

// Where prepared scenes are kept between runs: $XDG_CACHE_HOME/overfly, else ~/.cache/overfly.
[[nodiscard]] std::filesystem::path default_cache_folder();

struct PreparedTerrain {
    PreparedScene scene;
    bool from_cache = false;
    double seconds = 0.0;
};

// Elevation read, placed on the ellipsoid and meshed; or the same from the cache, if its inputs' contents and all that
// the document says of them have not changed. The scene's origin is the middle of the raster, on the ellipsoid. A cache
// that can't be written is not an error: the scene is prepared each time.
[[nodiscard]] PreparedTerrain prepare_terrain(const TerrainDocument& document,
                                              const std::filesystem::path& cache_folder, const Progress& progress = {});

}  // namespace overfly
