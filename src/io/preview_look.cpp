#include "io/preview_look.h"

#include <fstream>

#include <fmt/format.h>

namespace overfly {

std::string PreviewLook::remark() const {
    std::string text = fmt::format("Overfly preview: {}", view.name());
    if (burn_in.frame) text += ", frame";
    if (burn_in.place) text += ", place";
    if (burn_in.time) text += ", time";
    return text + '.';
}

bool carries_remark(const std::filesystem::path& file, const std::string& remark) {
    // PNG and MP4 both store it as it is, before the pictures; before it an MP4 has a table with some bytes a frame.
    constexpr std::size_t kLargestTable = std::size_t{1} << 22U;
    std::string head(kLargestTable, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(stream.gcount()));
    return head.find(remark) != std::string::npos;
}

}  // namespace overfly
