#pragma once

#include <cmath>

#include "io/frame_file.h"

namespace overfly {

// A picture in which every pixel differs, with values that half stores exactly, values that it rounds, and sky.
inline Frame sample_frame(int width, int height) {
    Frame frame;
    frame.width = width;
    frame.height = height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float u = static_cast<float>(x) / static_cast<float>(width);
            const float v = static_cast<float>(y) / static_cast<float>(height);
            frame.rgba.push_back({u, v, 0.25F + 0.5F * u * v, 1.0F});
            frame.depth_m.push_back(y == 0 ? Frame::kNoDepth : 1234.5678F + 100.0F * u - v);
        }
    }
    return frame;
}

// Channels of those layers, each with values of its own.
inline void add_layers(Frame& frame, LayerSet layers) {
    float number = 0.0F;
    for (const LayerKind& kind : layer_kinds()) {
        if (!layers.has(kind.layer)) continue;
        for (const std::string_view name : kind.channels) {
            LayerChannel& channel =
                frame.layers.emplace_back(LayerChannel{std::string(name), kind.type, kind.group, {}});
            number += 1.0F;
            for (std::size_t i = 0; i < frame.rgba.size(); ++i)
                channel.values.push_back(number + 0.001F * static_cast<float>(i));
        }
    }
}

// A camera that looks north and 30 degrees down from 4500 m above the scene's origin.
inline FrameHeader sample_header() {
    const double down = std::sin(Angle::degrees(30.0).radians()), level = std::cos(Angle::degrees(30.0).radians());
    FrameHeader header;
    header.number = 25;
    header.time_s = 1.0;
    header.rate = {24000, 1001};
    header.capture_rate = {24000, 1001};
    header.date = parse_local_time("2026-06-21T23:59:59.75-06:00");
    header.exposure_s = 1001.0 / 48000.0;
    header.shutter_angle = Angle::degrees(180.0);
    header.camera.position = {1000.0, 2000.0, 4500.0};
    header.camera.orientation = {{1, 0, 0}, {0, -down, -level}, {0, level, -down}};
    header.camera.tan_half_fov = 0.75;
    header.sensor_width_mm = 36.0;
    header.camera_place = {Angle::degrees(254.6), Angle::degrees(37.6), 4480.0};
    header.camera_altitude_m = 4500.0;
    header.scene_origin = {Angle::degrees(-105.45), Angle::degrees(37.55), 0.0};
    header.software = "overfly 0.1.0";
    header.shot = {"demo.yaml", std::string(64, 'a')};
    header.terrain = {"blanca_peak.yaml", std::string(64, 'b')};
    header.flight = {"ridge.yaml", ""};
    return header;
}

}  // namespace overfly
