#include "io/burn_in.h"

#include <cmath>

#include <fmt/format.h>

#include "io/frame_facts.h"
#include "io/picture_text.h"

namespace overfly {
namespace {

// To 11 m on the ground, which is more than a moving camera keeps still for.
std::string degrees_text(double deg, const char* positive, const char* negative) {
    return fmt::format("{:.4f}° {}", std::abs(deg), deg < 0.0 ? negative : positive);
}

std::string place_text(const FrameFacts& facts) {
    if (!facts.camera_place || !facts.altitude_m) return {};
    const double lon_deg = std::remainder(facts.camera_place->lon.degrees(), 360.0);
    return fmt::format("{}, {}, {} m", degrees_text(facts.camera_place->lat.degrees(), "N", "S"),
                       degrees_text(lon_deg, "E", "W"), std::lround(*facts.altitude_m));
}

std::string number_and_time_text(const BurnIn& wanted, const FrameFacts& facts) {
    const std::string number = wanted.frame && facts.number ? std::to_string(*facts.number) : "";
    const std::string time = wanted.time && facts.time_s ? fmt::format("{:.3f} s", *facts.time_s) : "";
    return number + (number.empty() || time.empty() ? "" : ", ") + time;
}

}  // namespace

std::vector<std::string> burn_in_lines(const BurnIn& wanted, const std::filesystem::path& frame) {
    if (wanted == BurnIn{}) return {};
    const FrameFacts facts = read_frame_facts(frame);
    std::vector<std::string> lines = {number_and_time_text(wanted, facts)};
    if (wanted.place) lines.push_back(place_text(facts));
    std::erase(lines, "");
    return lines;
}

void burn_in(DisplayImage& image, const std::vector<std::string>& lines, int dot_px) {
    int bottom = image.height;
    for (std::size_t i = lines.size(); i-- > 0;) {
        const std::string& line = lines[i];
        int scale = dot_px;
        while (scale > 1 && text_width_px(line, scale) > image.width) --scale;
        draw_text(image, line, 0, bottom, scale);
        bottom -= text_height_px(scale);
    }
}

}  // namespace overfly
