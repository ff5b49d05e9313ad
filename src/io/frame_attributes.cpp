#include "io/frame_attributes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "io/layer_attributes.h"

namespace overfly {
namespace {

constexpr const char* kComments =
    "World is east, north, up in metres at overfly:sceneOrigin; that and overfly:cameraPlace are longitude and "
    "latitude in degrees, height in metres above the WGS84 ellipsoid. altitude is above sea level (EGM96). The camera "
    "is that of the middle of the exposure; overfly:cameraMatrix is worldToCamera and overfly:worldToNDC is worldToNDC "
    "in double precision. R, G, B are linear light, premultiplied by A.";

FrameAttribute::Matrix44f single_precision(const RowMatrix& m) {
    FrameAttribute::Matrix44f single{};
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) single[row][column] = static_cast<float>(m[row][column]);
    }
    return single;
}

double longitude_deg(const Geodetic& place) { return std::remainder(place.lon.degrees(), 360.0); }

FrameAttribute::Vector3d degrees_and_metres(const Geodetic& place) {
    return {longitude_deg(place), place.lat.degrees(), place.height_m};
}

// The standard's text ends at whole seconds; the exact one has the fraction.
void append_date(std::vector<FrameAttribute>& attributes, const LocalTime& date) {
    const LocalTime second{std::chrono::floor<std::chrono::seconds>(date.utc), date.ahead_of_utc};
    std::string text = iso_text(second).substr(0, std::string_view("YYYY-MM-DDThh:mm:ss").size());
    std::replace(text.begin(), text.begin() + 10, '-', ':');
    text[10] = ' ';
    attributes.push_back({"capDate", text});
    // Of this attribute the standard says: UTC = local time + utcOffset.
    const std::chrono::seconds behind_utc = -date.ahead_of_utc;
    attributes.push_back({"utcOffset", static_cast<float>(behind_utc.count())});
    attributes.push_back({"overfly:date", iso_text(date)});
}

void append_time(std::vector<FrameAttribute>& attributes, const FrameHeader& header) {
    attributes.push_back({"imageCounter", header.number});
    attributes.push_back({"framesPerSecond", header.rate});
    attributes.push_back({"captureRate", header.capture_rate});
    attributes.push_back({"expTime", static_cast<float>(header.exposure_s)});
    attributes.push_back({"shutterAngle", static_cast<float>(header.shutter_angle.degrees())});
    if (const auto label = smpte_time(header.number, header.rate)) attributes.push_back({"timeCode", *label});
    attributes.push_back({"overfly:time", header.time_s});
    if (header.date) append_date(attributes, *header.date);
}

void append_camera(std::vector<FrameAttribute>& attributes, const FrameHeader& header, int width_px, int height_px) {
    const RowMatrix world_to_camera = exr_world_to_camera(header.camera);
    const double focal_length_mm = 0.5 * header.sensor_width_mm / header.camera.tan_half_fov;
    const double sensor_height_mm = header.sensor_width_mm * height_px / width_px;
    const FrameAttribute::Vector2f sensor_mm{static_cast<float>(header.sensor_width_mm),
                                             static_cast<float>(sensor_height_mm)};
    attributes.push_back({"worldToCamera", single_precision(world_to_camera)});
    const RowMatrix world_to_ndc = exr_world_to_ndc(header.camera, width_px, height_px);
    attributes.push_back({"worldToNDC", single_precision(world_to_ndc)});
    attributes.push_back({"pinholeFocalLength", static_cast<float>(focal_length_mm)});
    attributes.push_back({"sensorOverallDimensions", sensor_mm});
    attributes.push_back({"sensorCenterOffset", FrameAttribute::Vector2f{}});
    attributes.push_back({"overfly:cameraMatrix", world_to_camera});
    attributes.push_back({"overfly:worldToNDC", world_to_ndc});
}

void append_place(std::vector<FrameAttribute>& attributes, const FrameHeader& header) {
    attributes.push_back({"longitude", static_cast<float>(longitude_deg(header.camera_place))});
    attributes.push_back({"latitude", static_cast<float>(header.camera_place.lat.degrees())});
    attributes.push_back({"altitude", static_cast<float>(header.camera_altitude_m)});
    attributes.push_back({"overfly:cameraPlace", degrees_and_metres(header.camera_place)});
    attributes.push_back({"overfly:sceneOrigin", degrees_and_metres(header.scene_origin)});
}

void append_document(std::vector<FrameAttribute>& attributes, const std::string& kind, const NamedDocument& document) {
    attributes.push_back({"overfly:" + kind, document.name});
    if (!document.sha256.empty()) attributes.push_back({"overfly:" + kind + "Sha256", document.sha256});
}

void append_origin_of_frame(std::vector<FrameAttribute>& attributes, const FrameHeader& header) {
    attributes.push_back({"Software", header.software});  // the spelling of other renderers; the standard has none
    attributes.push_back({"comments", kComments});
    attributes.push_back({"overfly:depth", kDepthMeaning});
    append_document(attributes, "shot", header.shot);
    append_document(attributes, "terrain", header.terrain);
    append_document(attributes, "flight", header.flight);
    attributes.push_back({kInputsAttribute, header.inputs});
}

}  // namespace

std::vector<FrameAttribute> frame_attributes(const FrameHeader& header, int width_px, int height_px) {
    std::vector<FrameAttribute> attributes;
    append_time(attributes, header);
    append_camera(attributes, header, width_px, height_px);
    append_place(attributes, header);
    append_origin_of_frame(attributes, header);
    append_layers(attributes, header);
    return attributes;
}

}  // namespace overfly
