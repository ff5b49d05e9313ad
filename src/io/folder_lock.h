#pragma once

#include <filesystem>

namespace overfly {

// While it lives, no other program of ours has a lock on the folder: those that want one wait. It leaves no file
// behind, not even that of a program that is killed. File systems that know no such locks (some network shares) give
// none: then it does nothing.
class FolderLock {
  public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_;
};

}  // namespace overfly
