#include "geo/library_versions.h"

#include <GeographicLib/Constants.hpp>

namespace overfly {

std::vector<LibraryVersion> geo_library_versions() { return {{"GeographicLib", GEOGRAPHICLIB_VERSION_STRING}}; }

}  // namespace overfly
