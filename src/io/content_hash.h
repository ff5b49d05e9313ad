#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/sha256.h"

namespace overfly {

struct HashedFile {
    std::filesystem::path file;
    Sha256Digest sha256{};  // of what it holds
};

// Reads the files through, several at once. Throws UserError for one that can't be read.
[[nodiscard]] std::vector<HashedFile> hashed_files(std::span<const std::filesystem::path> files);

// SHA-256, in hexadecimal, of what the files contain and of `settings`: the key under which something made from them is
// kept. Names, folders and times of the files do not matter; their order does.
[[nodiscard]] std::string content_hash_of(std::span<const HashedFile> files, std::string_view settings);
// The same of hashed_files(files).
[[nodiscard]] std::string content_hash(std::span<const std::filesystem::path> files, std::string_view settings);

}  // namespace overfly
