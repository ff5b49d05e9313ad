#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/library_version.h"
#include "film/layers.h"
#include "flight/shutter.h"
#include "geo/frames.h"
#include "io/frame_digest.h"

namespace overfly {

// The manifest of a folder of frames: of each sequence in it, what it was made from, and of each of its frames that is
// complete, what the file holds. docs/manifest.md describes the file.

inline constexpr const char* kManifestName = "manifest.json";

struct ManifestInput {
    std::string what;    // "shot", "elevation" ...
    std::string file;    // relative to the manifest's folder, where that makes it shorter
    std::string sha256;  // of what it holds

    friend bool operator==(const ManifestInput&, const ManifestInput&) = default;
};

struct ManifestFrame {
    int number = 1;
    std::string file;              // without folder
    double time_s = 0.0;           // on the flight's axis
    std::uint64_t size_bytes = 0;  // with the files of layers
    std::string pixels_sha256;     // pixel_hash, of these as well
    FrameStatistics statistics;
    std::optional<double> render_s;  // what it took; nothing of one that was found on disk

    friend bool operator==(const ManifestFrame&, const ManifestFrame&) = default;
};

// A bound of pixels that the shot asks for, and the largest error found; nothing where nobody has looked.
struct ManifestBound {
    double asked_px = 0.0;
    std::optional<double> largest_px;

    friend bool operator==(const ManifestBound&, const ManifestBound&) = default;
};

struct ManifestSampling {
    std::string tracer;
    int lines = 0, samples = 0;
    double drift_px = 0.0, error = 0.0;

    friend bool operator==(const ManifestSampling&, const ManifestSampling&) = default;
};

struct ManifestSequence {
    std::string software;                          // "overfly 0.1.0"
    std::map<std::string, std::string> libraries;  // their versions
    std::vector<std::string> command;              // of the last run that rendered a frame of it
    std::string inputs;                            // the hash that all its frames carry
    std::vector<ManifestInput> files;
    std::string crs, vertical_datum;  // of the elevation
    Geodetic scene_origin;
    int width = 0, height = 0;
    FrameRate rate;
    int first = 1, count = 0;  // numbers of its frames, complete or not
    ManifestSampling sampling;
    ManifestBound mesh, motion;
    LayerSet layer_files;               // those in files of their own (io/layer_files.h)
    std::vector<ManifestFrame> frames;  // those that are complete, by number

    [[nodiscard]] const ManifestFrame* find(int number) const;
    friend bool operator==(const ManifestSequence&, const ManifestSequence&) = default;
};

struct Manifest {
    std::map<std::string, ManifestSequence> sequences;  // by the name of their files: NAME.0001.exr

    friend bool operator==(const Manifest&, const Manifest&) = default;
};

// Appears under its name when it is complete. Throws UserError when it can't be written.
void write_manifest(const std::filesystem::path& folder, const Manifest& manifest);

// Nothing where the folder has none. Throws UserError for a file that is no manifest, or one of a later version.
[[nodiscard]] std::optional<Manifest> read_manifest(const std::filesystem::path& folder);

}  // namespace overfly
