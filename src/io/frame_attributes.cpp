#include "io/frame_attributes.h"

#include <cmath>
#include <cstddef>

namespace overfly {
namespace {

constexpr const char* kComments =
    "World is east, north, up in metres at overfly:sceneOrigin; that and overfly:cameraPlace are longitude and "
    "latitude "
    "in degrees, height in metres above the WGS84 ellipsoid. altitude is above sea level (EGM96). overfly:cameraMatrix "
    "is worldToCamera in double precision. R, G, B are linear light, premultiplied by A.";

constexpr const char* kDepthMeaning =
    "planar distance along the view axis in metres, nearest in the pixel while the shutter is open; 1e10 = nothing but "
    "sky";

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

void append_time(std::vector<FrameAttribute>& attributes, const FrameHeader& header) {
    attributes.push_back({"imageCounter", header.number});
    attributes.push_back({"framesPerSecond", header.rate});
    attributes.push_back({"expTime", static_cast<float>(header.exposure_s)});
    attributes.push_back({"shutterAngle", static_cast<float>(header.shutter_angle.degrees())});
    if (const auto label = smpte_time(header.number, header.rate)) attributes.push_back({"timeCode", *label});
    attributes.push_back({"overfly:time", header.time_s});
}

void append_camera(std::vector<FrameAttribute>& attributes, const FrameHeader& header, int width_px, int height_px) {
    const RowMatrix world_to_camera = exr_world_to_camera(header.camera);
    const double focal_length_mm = 0.5 * header.sensor_width_mm / header.camera.tan_half_fov;
    const double sensor_height_mm = header.sensor_width_mm * height_px / width_px;
    const FrameAttribute::Vector2f sensor_mm{static_cast<float>(header.sensor_width_mm),
                                             static_cast<float>(sensor_height_mm)};
    attributes.push_back({"worldToCamera", single_precision(world_to_camera)});
    attributes.push_back({"worldToNDC", single_precision(exr_world_to_ndc(header.camera, width_px, height_px))});
    attributes.push_back({"pinholeFocalLength", static_cast<float>(focal_length_mm)});
    attributes.push_back({"sensorOverallDimensions", sensor_mm});
    attributes.push_back({"overfly:cameraMatrix", world_to_camera});
}

void append_place(std::vector<FrameAttribute>& attributes, const FrameHeader& header) {
    attributes.push_back({"longitude", static_cast<float>(longitude_deg(header.camera_place))});
    attributes.push_back({"latitude", static_cast<float>(header.camera_place.lat.degrees())});
    attributes.push_back({"altitude", static_cast<float>(header.camera_altitude_m)});
    attributes.push_back({"overfly:cameraPlace", degrees_and_metres(header.camera_place)});
    attributes.push_back({"overfly:sceneOrigin", degrees_and_metres(header.scene_origin)});
}

void append_origin_of_frame(std::vector<FrameAttribute>& attributes, const FrameHeader& header) {
    attributes.push_back({"Software", header.software});  // the spelling of other renderers; the standard has none
    attributes.push_back({"comments", kComments});
    attributes.push_back({"overfly:depth", kDepthMeaning});
    attributes.push_back({"overfly:shot", header.shot});
    attributes.push_back({"overfly:terrain", header.terrain});
    attributes.push_back({"overfly:flight", header.flight});
    attributes.push_back({kInputsAttribute, header.inputs});
}

}  // namespace

std::vector<FrameAttribute> frame_attributes(const FrameHeader& header, int width_px, int height_px) {
    std::vector<FrameAttribute> attributes;
    append_time(attributes, header);
    append_camera(attributes, header, width_px, height_px);
    append_place(attributes, header);
    append_origin_of_frame(attributes, header);
    return attributes;
}

}  // namespace overfly
