#include "io/exr_complaint.h"

#include <string_view>

namespace overfly {

std::string exr_complaint(const std::exception& error) {
    // 'Cannot read image file "NAME". Early end of file: ...', or the same of a scan line or a pixel
    std::string_view what = error.what();
    if (what.find("Early end of file") != std::string_view::npos) return kCutOff;
    const std::size_t name_end = what.find("\". ");
    if (what.starts_with("Cannot ") && name_end != std::string_view::npos) what.remove_prefix(name_end + 3);
    while (what.ends_with('.') || what.ends_with('\n')) what.remove_suffix(1);
    return std::string(what);
}

}  // namespace overfly
