#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace overfly {

// SHA-256, in hexadecimal, of what the files contain and of `settings`: the key under which something made from them is
// kept. Names, folders and times of the files do not matter; their order does. Throws UserError for a file that can't
// be read.
[[nodiscard]] std::string content_hash(std::span<const std::filesystem::path> files, std::string_view settings);

}  // namespace overfly
