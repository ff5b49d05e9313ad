#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>

#include "io/temporary_file.h"

namespace overfly {

// A binary file that appears under its name only when it is complete.
// GUARANTEES: once anything could not be stored (disk full, quota, broken share), every later call throws as well, so
// that an error which a library swallows on its way out is still found by commit(). All errors are UserErrors that name
// the file and give the system's words.
class OutputFile {
  public:
    explicit OutputFile(const std::filesystem::path& file);

    void write(std::span<const std::byte> bytes);
    void seek(std::uint64_t offset);
    [[nodiscard]] std::uint64_t position() const { return position_; }

    // Stores what is still buffered and closes the file, which has no name yet. Only commit() may follow.
    void close();
    // Closes the file, where close() has not, and gives it its name. Nothing may follow.
    void commit();

  private:
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    [[noreturn]] void fail(int error_number);
    void refuse_if_failed();

    TemporaryFile temporary_;
    std::unique_ptr<std::FILE, Close> stream_;  // after temporary_: closed before the file is removed
    std::uint64_t position_ = 0;
    int error_number_ = 0;  // errno of the first failure
};

}  // namespace overfly
