#include "io/scene_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/parallel.h"
#include "io/output_file.h"
#include "io/scene_facts.h"
#include "io/sha256.h"

namespace overfly {
namespace {

// The file: a head, the facts, then the mesh's five arrays as they lie in memory (little-endian, no padding).
struct Head {
    std::array<char, 12> magic = {'o', 'v', 'e', 'r', 'f', 'l', 'y', ' ', 's', 'c', 'n', '\n'};
    std::uint32_t version = 2;  // raise it with every change of the layout, or of what a mesh means
    std::uint64_t facts_size = 0, vertex_count = 0, triangle_count = 0;
    Sha256Digest facts_digest{}, mesh_digest{};
};
static_assert(sizeof(Head) == 16 + 3 * 8 + 2 * 32);
static_assert(sizeof(Point<Scene>) == 24 && sizeof(GridPlace) == 8 && sizeof(std::array<std::uint32_t, 3>) == 12);

constexpr std::size_t kChunkBytes = std::size_t{1} << 24;

using Arrays = std::array<std::span<const std::byte>, 5>;
Arrays arrays(const TerrainMesh& mesh) {
    return {std::as_bytes(std::span(mesh.positions)), std::as_bytes(std::span(mesh.elevation_m)),
            std::as_bytes(std::span(mesh.samples)), std::as_bytes(std::span(mesh.triangles)),
            std::as_bytes(std::span(mesh.twins))};
}

// A piece of one array, and where it begins in the file.
struct Chunk {
    std::span<const std::byte> bytes;
    std::uint64_t file_offset = 0;
};

std::vector<Chunk> chunks(const TerrainMesh& mesh, std::uint64_t file_offset) {
    std::vector<Chunk> all;
    for (std::span<const std::byte> rest : arrays(mesh))
        while (!rest.empty()) {
            const std::size_t size = std::min(rest.size(), kChunkBytes);
            all.push_back({rest.first(size), file_offset});
            rest = rest.subspan(size);
            file_offset += size;
        }
    return all;
}

std::uint64_t file_size(const Head& head) {
    return sizeof(Head) + head.facts_size +
           head.vertex_count * (sizeof(Point<Scene>) + sizeof(float) + sizeof(GridPlace)) +
           head.triangle_count * (sizeof(TerrainMesh::triangles[0]) + sizeof(TerrainMesh::twins[0]));
}

// Reads at any offset; usable by many threads at once.
class InputFile {
  public:
    explicit InputFile(const std::filesystem::path& file) : descriptor_(open(file.c_str(), O_RDONLY | O_CLOEXEC)) {}
    ~InputFile() {
        if (descriptor_ >= 0) close(descriptor_);
    }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    [[nodiscard]] std::uint64_t size() const {
        struct stat status {};
        return fstat(descriptor_, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
    }
    [[nodiscard]] bool read(std::span<std::byte> bytes, std::uint64_t offset) const {
        while (!bytes.empty()) {
            const ssize_t count = pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
            if (count <= 0) return false;
            bytes = bytes.subspan(static_cast<std::size_t>(count));
            offset += static_cast<std::uint64_t>(count);
        }
        return true;
    }

  private:
    int descriptor_;
};

// Head and facts; the head only when it is of this version and the file's size is what it says.
std::optional<Head> read_head(const InputFile& input, PreparedScene& scene) {
    Head head;
    const Head expected;
    if (!input.read(std::as_writable_bytes(std::span(&head, 1)), 0)) return std::nullopt;
    if (head.magic != expected.magic || head.version != expected.version) return std::nullopt;
    // Bounds first: sizes from a damaged head must not overflow, nor be allocated.
    const std::uint64_t size = input.size();
    if (std::max({head.facts_size, head.vertex_count, head.triangle_count}) > size) return std::nullopt;
    if (file_size(head) != size) return std::nullopt;
    std::vector<std::byte> facts(head.facts_size);
    if (!input.read(facts, sizeof(Head)) || sha256(facts) != head.facts_digest) return std::nullopt;
    if (!read_scene_facts(facts, scene)) return std::nullopt;
    return head;
}

}  // namespace

void save_scene(const std::filesystem::path& file, const PreparedScene& scene) {
    const std::vector<std::byte> facts = scene_facts(scene);
    Head head;
    head.facts_size = facts.size();
    head.vertex_count = scene.mesh.positions.size();
    head.triangle_count = scene.mesh.triangles.size();
    head.facts_digest = sha256(facts);
    const std::vector<Chunk> pieces = chunks(scene.mesh, 0);
    std::vector<Sha256Digest> digests(pieces.size());
    parallel_for(pieces.size(), [&](std::size_t i) { digests[i] = sha256(pieces[i].bytes); });
    head.mesh_digest = sha256(std::as_bytes(std::span(digests)));

    OutputFile output(file);
    output.write(std::as_bytes(std::span(&head, 1)));
    output.write(facts);
    for (const std::span<const std::byte> array : arrays(scene.mesh))
        if (!array.empty()) output.write(array);
    output.commit();
}

std::optional<PreparedScene> load_scene(const std::filesystem::path& file) {
    const InputFile input(file);
    PreparedScene scene;
    const std::optional<Head> head = read_head(input, scene);
    if (!head) return std::nullopt;
    scene.mesh.positions.resize(head->vertex_count);
    scene.mesh.elevation_m.resize(head->vertex_count);
    scene.mesh.samples.resize(head->vertex_count);
    scene.mesh.triangles.resize(head->triangle_count);
    scene.mesh.twins.resize(head->triangle_count);

    const std::vector<Chunk> pieces = chunks(scene.mesh, sizeof(Head) + head->facts_size);
    std::vector<Sha256Digest> digests(pieces.size());
    std::atomic<bool> is_read = true;
    parallel_for(pieces.size(), [&](std::size_t i) {
        // The chunks are views of vectors that this function owns.
        auto* const begin = const_cast<std::byte*>(pieces[i].bytes.data());
        if (!input.read({begin, pieces[i].bytes.size()}, pieces[i].file_offset)) is_read = false;
        digests[i] = sha256(pieces[i].bytes);
    });
    if (!is_read || sha256(std::as_bytes(std::span(digests))) != head->mesh_digest) return std::nullopt;
    return scene;
}

std::optional<std::string> scene_content_hash(const std::filesystem::path& file) {
    const InputFile input(file);
    PreparedScene scene;
    if (!read_head(input, scene)) return std::nullopt;
    return scene.content_hash;
}

}  // namespace overfly
