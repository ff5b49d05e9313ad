#include "io/library_versions.h"

#include <OpenColorIO/OpenColorIO.h>
#include <OpenEXR/OpenEXRConfig.h>
#include <OpenImageIO/imageio.h>
#include <assimp/version.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <fmt/format.h>

namespace overfly {

std::vector<LibraryVersion> io_library_versions() {
    int major = 0;
    int minor = 0;
    int patch = 0;
    OSRGetPROJVersion(&major, &minor, &patch);
    const int oiio = OIIO::openimageio_version();
    return {{"GDAL", GDALVersionInfo("RELEASE_NAME")},
            {"PROJ", fmt::format("{}.{}.{}", major, minor, patch)},
            {"OpenEXR", OPENEXR_VERSION_STRING},
            {"OpenImageIO", fmt::format("{}.{}.{}", oiio / 10000, oiio / 100 % 100, oiio % 100)},
            {"OpenColorIO", OCIO_NAMESPACE::GetVersion()},
            {"Assimp", fmt::format("{}.{}.{}", aiGetVersionMajor(), aiGetVersionMinor(), aiGetVersionPatch())}};
}

}  // namespace overfly
