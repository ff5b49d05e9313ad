#include "io/temporary_file.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <mutex>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>

#include "core/error.h"

namespace overfly {
namespace {

constexpr std::size_t kRandomDigits = 8;

// ".tmp-MACHINE-", before the process id.
std::string machine_tag() {
    std::array<char, 256> name{};
    if (gethostname(name.data(), name.size() - 1) != 0) name[0] = '\0';
    return fmt::format(".tmp-{}-", name.data());
}

// Machine and process tell whose a leftover is. The random part is needed as well: containers may share both.
std::filesystem::path temporary_name(const std::filesystem::path& target) {
    const unsigned random = std::random_device()();
    return fmt::format(".{}{}{}-{:0{}x}", target.filename().string(), machine_tag(), getpid(), random, kRandomDigits);
}

// The process that made the temporary file of this name, 0 where it is none of this machine's.
pid_t maker_of(std::string_view name, std::string_view machine) {
    const std::size_t tag = name.rfind(machine);
    if (!name.starts_with('.') || tag == std::string_view::npos) return 0;
    const std::string_view rest = name.substr(tag + machine.size());
    pid_t process = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), process);
    const std::string_view random = rest.substr(static_cast<std::size_t>(end - rest.data()));
    const bool is_whole = random.size() == 1 + kRandomDigits && random.starts_with('-') &&
                          random.find_first_not_of("0123456789abcdef", 1) == std::string_view::npos;
    return error == std::errc() && is_whole ? process : 0;
}

bool is_gone(pid_t process) { return kill(process, 0) != 0 && errno == ESRCH; }

// What is being made belongs to the process, as its name does.
struct Unfinished {
    std::mutex mutex;
    std::set<std::filesystem::path> files;
};

Unfinished& unfinished() {
    static Unfinished all;
    return all;
}

}  // namespace

TemporaryFile::TemporaryFile(std::filesystem::path target)
    : target_(std::move(target)), path_(target_.parent_path() / temporary_name(target_)) {
    const std::scoped_lock lock(unfinished().mutex);
    unfinished().files.insert(path_);
}

TemporaryFile::~TemporaryFile() {
    const std::scoped_lock lock(unfinished().mutex);
    std::error_code ignored;
    if (!committed_) std::filesystem::remove(path_, ignored);
    unfinished().files.erase(path_);
}

void TemporaryFile::commit() {
    const std::scoped_lock lock(unfinished().mutex);
    std::error_code error;
    std::filesystem::rename(path_, target_, error);
    if (error) throw UserError(Place{target_}, fmt::format("can't be written: {}", error.message()));
    committed_ = true;
}

void remove_unfinished_files() {
    // Never unlocked again: nothing may be committed or made until the process ends.
    unfinished().mutex.lock();
    std::error_code ignored;
    for (const std::filesystem::path& file : unfinished().files) std::filesystem::remove(file, ignored);
}

void remove_abandoned_files(const std::filesystem::path& folder) {
    const std::string machine = machine_tag();
    std::error_code error;
    for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const pid_t maker = maker_of(entry->path().filename().string(), machine);
        std::error_code ignored;
        if (maker > 0 && is_gone(maker)) std::filesystem::remove(entry->path(), ignored);
    }
}

}  // namespace overfly
