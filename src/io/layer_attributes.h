#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/frame_attributes.h"

namespace overfly {

// Of what the layers of a file are: a line "channels: meaning" for each.
inline constexpr const char* kLayersAttribute = "overfly:layers";
// The names of the layers that have files of their own, with spaces between them.
inline constexpr const char* kLayerFilesAttribute = "overfly:layerFiles";
// As Cryptomatte's manifest, for whoever looks up the numbers of the layer `id`.
inline constexpr const char* kObjectsAttribute = "overfly:objects";

void append_layers(std::vector<FrameAttribute>& attributes, const FrameHeader& header);

// JSON: each name with its number in 8 hexadecimal digits, by name. Bytes that are no UTF-8 are replaced.
[[nodiscard]] std::string cryptomatte_manifest(std::span<const std::string> names);

}  // namespace overfly
