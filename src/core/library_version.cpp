#include "core/library_version.h"

#include <oneapi/tbb/version.h>

namespace overfly {

std::vector<LibraryVersion> core_library_versions() { return {{"oneTBB", TBB_runtime_version()}}; }

}  // namespace overfly
