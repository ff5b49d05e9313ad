#include "shot/library_versions.h"

#include "config/library_versions.h"
#include "geo/library_versions.h"
#include "io/library_versions.h"
#include "mesh/library_versions.h"
#include "trace/library_versions.h"

namespace overfly {

std::vector<LibraryVersion> all_library_versions() {
    std::vector<LibraryVersion> all;
    for (const auto& versions : {core_library_versions(), geo_library_versions(), mesh_library_versions(),
                                 trace_library_versions(), io_library_versions(), config_library_versions()}) {
        all.insert(all.end(), versions.begin(), versions.end());
    }
    return all;
}

}  // namespace overfly
