#include "mesh/library_versions.h"

#include <geos_c.h>

namespace overfly {

std::vector<LibraryVersion> mesh_library_versions() { return {{"GEOS", GEOSversion()}}; }

}  // namespace overfly
