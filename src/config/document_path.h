#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace overfly::config {

// Names that GDAL understands and the file system does not: /vsizip/a.zip/b.tif, NETCDF:"a.nc":z, a URL, or a VRT
// written in place. They are kept as they are.
[[nodiscard]] bool is_gdal_name(std::string_view text);

// A path relative to `folder`, as one relative to the working directory or absolute. `..` is taken out where that
// names the same file (behind a symbolic link it does not).
[[nodiscard]] std::filesystem::path path_in(const std::filesystem::path& folder, const std::filesystem::path& path);

}  // namespace overfly::config
