#pragma once

#include <span>
#include <string>
#include <vector>

#include "config/documents.h"
#include "io/content_hash.h"

namespace overfly {

// A file that a shot is rendered from.
struct InputFile {
    std::string
        what;  // "shot", "terrain", "flight", "elevation", "colours", "classes", "flight of NAME", "mesh of NAME"
    HashedFile content;
};

// All of them: the documents, meshes and flights of bodies, the colour table, the raster of classes, and at last the
// elevation, which whoever prepared the terrain has read. Throws UserError for one that can't be read.
[[nodiscard]] std::vector<InputFile> input_files(const ShotDocument& shot, std::span<const HashedFile> elevation);

}  // namespace overfly
