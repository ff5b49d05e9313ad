#pragma once

#include <filesystem>

namespace overfly {

// A name for a file that is being made: hidden, beside the file it will become, and unlike any other process's or
// machine's that makes the same file. What carries the name is removed with this object unless commit() came first.
class TemporaryFile {
  public:
    explicit TemporaryFile(std::filesystem::path target);
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] const std::filesystem::path& target() const { return target_; }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    // Renames the temporary file to its target, in one step, replacing what was there. Throws UserError.
    void commit();

  private:
    std::filesystem::path target_, path_;
    bool committed_ = false;
};

// For a program that has to end at once, without unwinding: removes all that carry such a name in this process. None is
// committed or made afterwards: a thread that tries to waits for ever.
void remove_unfinished_files();

// Removes from `folder` what programs that were killed left there under such names: those of this machine whose
// process is gone. What other machines and running processes are making stays. Never fails.
void remove_abandoned_files(const std::filesystem::path& folder);

}  // namespace overfly
