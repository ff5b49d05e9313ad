#include "config/document_path.h"

#include <algorithm>
#include <system_error>

namespace overfly::config {

bool is_gdal_name(std::string_view text) {
    if (text.starts_with("/vsi") || text.starts_with('<') || text.find("://") != std::string_view::npos) return true;
    // A driver's prefix is in capitals; one letter would be a drive.
    const std::size_t colon = text.find(':');
    return colon != std::string_view::npos && colon >= 2 && std::ranges::all_of(text.substr(0, colon), [](char c) {
               return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
           });
}

std::filesystem::path path_in(const std::filesystem::path& folder, const std::filesystem::path& path) {
    std::filesystem::path joined = folder / path;
    std::filesystem::path shortened = joined.lexically_normal();
    std::error_code no_such_file;
    const bool same = std::filesystem::equivalent(joined, shortened, no_such_file);
    return same && !no_such_file ? shortened : joined;
}

}  // namespace overfly::config
