#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/error.h"

// What the tests of documents share: the good documents of the repository and a folder of their own.
namespace overfly::config_tests {

inline const std::filesystem::path source_folder = OVERFLY_SOURCE_DIR;
inline const std::filesystem::path good_folder = source_folder / "tests/config/good";

inline std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// A new folder that is gone with this object.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "overfly_config_XXXXXX").string();
        check(mkdtemp(name.data()) != nullptr, "a temporary folder can be made");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::filesystem::remove(path_ / name);  // replacing a file's content may wait for the disk
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

  private:
    std::filesystem::path path_;
};

// The lines that a failing `read` would print, or "no error".
template <class Read>
std::string error_text(const Read& read) {
    try {
        read();
    } catch (const UserError& e) {
        return e.what();
    }
    return "no error";
}

}  // namespace overfly::config_tests
