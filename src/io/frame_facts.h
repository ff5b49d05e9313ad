#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "flight/keyframe.h"
#include "io/exr_camera.h"
#include "io/frame_file.h"
#include "io/smpte_time.h"

namespace overfly {

// What the header of an OpenEXR file says, of whatever program it is: the rest is empty. Doubles are those that
// `overfly:` attributes keep, where there are such.
struct FrameFacts {
    int width = 0, height = 0;
    std::optional<int> number;
    std::optional<double> time_s;  // on the flight's axis
    std::optional<FrameRate> rate, capture_rate;
    std::optional<double> exposure_s, shutter_angle_deg;
    std::optional<SmpteTime> time_code;
    std::string date;  // ISO 8601, or as capDate has it

    std::optional<RowMatrix> world_to_camera;
    double screen_window_width = 1.0;  // of the picture at depth 1
    std::optional<double> focal_length_mm, sensor_width_mm;
    std::optional<Geodetic> camera_place, scene_origin;
    std::optional<double> altitude_m;  // above sea level

    LayerSet layer_files;  // those in files of their own (io/layer_files.h)
    std::string objects;   // JSON, as Cryptomatte's manifest: each with its number
    std::string software, inputs;
    NamedDocument shot, terrain, flight;
};

// Reads no pixels. Throws UserError: no such file, not OpenEXR, or cut off within its header.
[[nodiscard]] FrameFacts read_frame_facts(const std::filesystem::path& file);

// How the camera is turned, against the horizon at its place; heading in [0, 360] degrees. Nothing where the header
// does not say enough.
[[nodiscard]] std::optional<Attitude> camera_attitude(const FrameFacts& facts);

}  // namespace overfly
