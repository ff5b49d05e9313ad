#pragma once

#include <string>
#include <vector>

namespace overfly {

// A library that the program runs on.
struct LibraryVersion {
    std::string name, version;
};

// oneTBB. The modules that use the others say theirs (MODULE/library_versions.h).
[[nodiscard]] std::vector<LibraryVersion> core_library_versions();

}  // namespace overfly
