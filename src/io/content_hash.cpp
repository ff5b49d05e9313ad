#include "io/content_hash.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <system_error>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"

namespace overfly {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int error_number) {
    throw UserError({file}, "can't be read: " + std::generic_category().message(error_number));
}

Sha256Digest file_digest(const std::filesystem::path& file) {
    struct Close {
        void operator()(std::FILE* stream) const { std::fclose(stream); }
    };
    const std::unique_ptr<std::FILE, Close> stream(std::fopen(file.c_str(), "rbe"));
    if (!stream) fail(file, errno);
    Sha256 hash;
    std::vector<std::byte> buffer(std::size_t{1} << 20);
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), stream.get()))
        hash.add({buffer.data(), count});
    if (std::ferror(stream.get()) != 0) fail(file, errno);
    return hash.digest();
}

}  // namespace

std::vector<HashedFile> hashed_files(std::span<const std::filesystem::path> files) {
    std::vector<HashedFile> hashed(files.size());
    parallel_for(files.size(), [&](std::size_t i) { hashed[i] = {files[i], file_digest(files[i])}; });
    return hashed;
}

std::string content_hash_of(std::span<const HashedFile> files, std::string_view settings) {
    // Each part has its own digest, so that no byte can move from one part to the next unseen.
    std::vector<Sha256Digest> parts;
    for (const HashedFile& file : files) parts.push_back(file.sha256);
    parts.push_back(sha256(std::as_bytes(std::span(settings))));
    return hex(sha256(std::as_bytes(std::span(parts))));
}

std::string content_hash(std::span<const std::filesystem::path> files, std::string_view settings) {
    return content_hash_of(hashed_files(files), settings);
}

}  // namespace overfly
