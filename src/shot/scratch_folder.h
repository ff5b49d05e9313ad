#pragma once

#include <filesystem>

namespace overfly {

// A folder for the frame that a bench writes; goes away with it.
class ScratchFolder {
  public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    [[nodiscard]] std::filesystem::path file() const { return path_ / "frame.exr"; }

  private:
    std::filesystem::path path_;
};

}  // namespace overfly
