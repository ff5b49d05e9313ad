#include "config/library_versions.h"

namespace overfly {

// yaml-cpp does not say its version at run time; this is the one that the program was built with.
std::vector<LibraryVersion> config_library_versions() { return {{"yaml-cpp", OVERFLY_YAML_CPP_VERSION}}; }

}  // namespace overfly
