#include "io/temporary_file.h"

#include <random>
#include <system_error>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

#include "core/error.h"

namespace overfly {
namespace {

// The process id lets a person tell whose a leftover is. The random part is needed as well: in containers and on farms
// processes of different machines have the same id.
std::filesystem::path temporary_name(const std::filesystem::path& target) {
    const unsigned random = std::random_device()();
    return fmt::format(".{}.tmp-{}-{:08x}", target.filename().string(), getpid(), random);
}

}  // namespace

TemporaryFile::TemporaryFile(std::filesystem::path target)
    : target_(std::move(target)), path_(target_.parent_path() / temporary_name(target_)) {}

TemporaryFile::~TemporaryFile() {
    std::error_code ignored;
    if (!committed_) std::filesystem::remove(path_, ignored);
}

void TemporaryFile::commit() {
    std::error_code error;
    std::filesystem::rename(path_, target_, error);
    if (error) throw UserError(Place{target_}, fmt::format("can't be written: {}", error.message()));
    committed_ = true;
}

}  // namespace overfly
