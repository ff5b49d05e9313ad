#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/local_time.h"
#include "film/frame.h"
#include "film/frame_storage.h"
#include "flight/camera_path.h"
#include "flight/lens.h"
#include "flight/shutter.h"
#include "geo/frames.h"
#include "io/frame_digest.h"

namespace overfly {

// A document that a frame comes from.
struct NamedDocument {
    std::string name;    // of its file, without folders
    std::string sha256;  // of what it holds; empty: not known

    friend bool operator==(const NamedDocument&, const NamedDocument&) = default;
};

// What a frame's header says beside its pixels.
struct FrameHeader {
    int number = 1;
    double time_s = 0.0;  // of the frame, on the flight's axis
    FrameRate rate;
    FrameRate capture_rate;         // exposures per second of the flight: `rate`, unless time is slowed down
    std::optional<LocalTime> date;  // when the simulated flight is at time_s
    double exposure_s = 0.0;
    Angle shutter_angle;
    CameraPose camera;  // at the middle of the exposure
    double sensor_width_mm = 36.0;
    Geodetic camera_place;           // the same camera on the ellipsoid
    double camera_altitude_m = 0.0;  // above sea level (EGM96)
    Geodetic scene_origin;
    std::string software;  // "overfly 0.1.0"
    NamedDocument shot, terrain, flight;
    std::string inputs;                  // a hash of all that the pixels were made from
    LayerSet layers;                     // of the frame, beside R, G, B, A and Z
    std::vector<std::string> objects{};  // what the layers `id` and `cryptomatte` may show
    // Where a frame's layers have files of their own (io/layer_files.h):
    LayerSet layer_files;        // those that have one; the others are in this file
    bool is_of_a_layer = false;  // this file is one of them: of `layers`, without R, G, B, A and Z
};

// Writes an OpenEXR file with half R, G, B, A, float Z and the frame's layers in their types, compressed as `storage`
// says, under a temporary name beside `file`, and renames it into place when it is complete. Where the groups of layers
// are compressed differently, each is a part of its own (`beauty`, `data`) with the same header: OpenEXR has one
// compression a part. Standard attributes where there are some (framesPerSecond, expTime, shutterAngle, worldToCamera,
// worldToNDC, longitude, latitude, altitude, ...), Cryptomatte's, `overfly:` ones for the rest; "world" is the Scene
// frame. Layers of header.layer_files go into files of their own beside it, with the same header. Throws UserError that
// names the file when it cannot be written (no such folder, no permission, disk full); nothing unfinished is left
// behind. REQUIRES: all values but those of StoredAs::Uint are finite; storage.data is lossless; header.layer_files are
// among the frame's layers. GUARANTEES: `file` is renamed when the files of its layers have been. What is stored as
// half and beyond its range (65504) becomes its end.
void write_frame(const std::filesystem::path& file, const Frame& frame, const FrameHeader& header,
                 const FrameStorage& storage = {});

// The same; what digest_frame says of the file then. One that is stored without loss is not read again for that.
FrameDigest write_digested_frame(const std::filesystem::path& file, const Frame& frame, const FrameHeader& header,
                                 const FrameStorage& storage = {});

// Whether `file` is a frame that can be read to its last line, and so are the files of its layers.
[[nodiscard]] bool is_complete_frame(const std::filesystem::path& file);

// The `inputs` that the frame was written with; nothing where the file says none or is no frame at all.
[[nodiscard]] std::optional<std::string> frame_inputs(const std::filesystem::path& file);

// Reads R, G, B, A and Z back, in whichever part they are. Throws UserError.
[[nodiscard]] Frame read_frame(const std::filesystem::path& file);

// The same with all layers, in whichever file they are, whose channels have the names of layer_kinds(). Throws
// UserError.
[[nodiscard]] Frame read_frame_with_layers(const std::filesystem::path& file);

}  // namespace overfly
