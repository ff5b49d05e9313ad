#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "io/scene_file.h"

namespace overfly {

// All of a prepared scene but its mesh, as bytes of the scene file: the fields in order, numbers little-endian, texts
// and lists with their length before them.
[[nodiscard]] std::vector<std::byte> scene_facts(const PreparedScene& scene);

// The way back; false, and `scene` in any state, unless all bytes are used up exactly.
[[nodiscard]] bool read_scene_facts(std::span<const std::byte> bytes, PreparedScene& scene);

}  // namespace overfly
