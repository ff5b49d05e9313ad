#pragma once

#include <string>

#include "config/documents.h"

namespace overfly {

// A hash of everything that a frame's pixels depend on: the terrain's content, the flight, bodies with their meshes and
// flights, picture, shutter, sampling, look and layers, and this version of the program; not of names (but for those
// that Cryptomatte shows), folders and the choice of frames. Written into every frame, so that a later run knows which
// frames on disk are still what the shot says. scene_hash: PreparedScene::content_hash. Throws UserError where a mesh
// or a raster of classes can't be read.
[[nodiscard]] std::string shot_inputs_hash(const ShotDocument& shot, const std::string& scene_hash);

}  // namespace overfly
