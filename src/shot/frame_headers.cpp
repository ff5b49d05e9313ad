#include "shot/frame_headers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/version.h"

namespace overfly {
namespace {

NamedDocument document_of(std::span<const InputFile> files, std::string_view what) {
    const auto found = std::ranges::find(files, what, &InputFile::what);
    if (found == files.end()) return {};
    return {found->content.file.filename().string(), hex(found->content.sha256)};
}

// Of a camera that would have filmed the flight so, to a thousandth of a frame per second.
FrameRate rate_of(double lasts_s) {
    constexpr std::int32_t kThousandths = 1000;
    constexpr double kMost = 2e9;
    const double rate = std::min(std::round(kThousandths / lasts_s), kMost);
    const std::int32_t thousandths = std::max(1, static_cast<std::int32_t>(rate));
    const std::int32_t common = std::gcd(thousandths, kThousandths);
    return {thousandths / common, kThousandths / common};
}

}  // namespace

FrameHeaders::FrameHeaders(const ShotDocument& shot, const Stage& stage, const CameraPath& path, std::string inputs,
                           std::span<const InputFile> files, std::span<const std::string> objects)
    : shot_(&shot), stage_(&stage), path_(&path) {
    common_.rate = shot.frames.rate;
    common_.capture_rate = shot.frames.rate;
    common_.shutter_angle = shot.shutter.angle;
    common_.sensor_width_mm = shot.flight.keyframes.front().lens.sensor_width_mm;
    common_.scene_origin = stage.frame().origin();
    common_.software = fmt::format("overfly {}", kVersion);
    common_.shot = document_of(files, "shot");
    common_.terrain = document_of(files, "terrain");
    common_.flight = document_of(files, "flight");
    common_.inputs = std::move(inputs);
    common_.layers = shot.layers;
    if (shot.output.layer_files) common_.layer_files = shot.layers;
    common_.objects.assign(objects.begin(), objects.end());
}

FrameHeader FrameHeaders::of(const PlannedFrame& frame) const {
    const double time_s = frame.exposure.centre_s();
    FrameHeader header = common_;
    header.number = frame.number;
    header.time_s = frame.time_s;
    if (shot_->frames.date) header.date = later(*shot_->frames.date, frame.time_s - path_->times().begin_s);
    header.exposure_s = frame.exposure.duration_s();
    if (frame.lasts_s > 0.0) {
        if (!shot_->frames.speeds.empty()) header.capture_rate = rate_of(frame.lasts_s);
        if (shot_->shutter.seconds) header.shutter_angle = Angle::degrees(360.0 * header.exposure_s / frame.lasts_s);
    }
    header.camera = path_->pose_at(time_s);
    header.camera_place = path_->place_at(time_s);
    header.camera_altitude_m =
        header.camera_place.height_m - stage_->sea_level_m(header.camera_place.lon, header.camera_place.lat);
    return header;
}

}  // namespace overfly
