#include "shot/scratch_folder.h"

#include <string>
#include <system_error>

#include <unistd.h>

namespace overfly {

ScratchFolder::ScratchFolder()
    : path_(std::filesystem::temp_directory_path() / ("overfly-bench-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace overfly
