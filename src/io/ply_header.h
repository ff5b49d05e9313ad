#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace overfly {

// What is wrong with the header of a PLY file, or nothing: whatever would keep assimp 5.2 busy for ever or let it ask
// for all memory. It must start as one and end, and count no more elements than the rest of the file has bytes.
[[nodiscard]] std::optional<std::string> ply_header_fault(const std::filesystem::path& file);

}  // namespace overfly
