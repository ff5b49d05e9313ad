#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "flight/keyframe.h"
#include "flight/shutter.h"
#include "shade/look.h"
#include "terrain/elevation_source.h"
#include "trace/tracer_kind.h"

namespace overfly {

// The three kinds of document, as validated values. Paths are absolute or relative to the working directory: where a
// document gives one relative to itself, the reader has resolved it.

// terrain/NAME.yaml: which rasters, and what their numbers mean.
struct TerrainDocument {
    std::filesystem::path file;
    ElevationSource source;
};

// camera_paths/NAME.yaml
struct FlightDocument {
    std::filesystem::path file;
    std::vector<Keyframe> keyframes;  // times strictly increasing, at least one
    std::vector<Place> places;        // where each keyframe stands in the document
};

struct LookDocument {
    std::filesystem::path colours;  // a GDAL colour-relief file; empty: the built-in ramp
    Look look;
};

struct FramesDocument {
    int first = 1;             // number of the first frame
    std::optional<int> count;  // none: as many as the flight lasts
    FrameRate rate;
    double start_s = 0.0;  // flight time of the first frame, from the flight's first keyframe
};

struct ImageDocument {
    int width = 960, height = 540;
    bool transparent_sky = false;
};

struct SamplingDocument {
    TracerKind tracer = TracerKind::Interval;
    int lines = 4;     // per pixel: continuous tracers
    int samples = 64;  // per pixel: the discrete tracer
};

struct OutputDocument {
    std::filesystem::path folder;
    std::string name;  // frames are NAME.0001.exr
    bool contact_sheet = true;
    bool movie = true;
};

// configs/NAME.yaml: one shot.
struct ShotDocument {
    std::filesystem::path file;
    TerrainDocument terrain;
    FlightDocument flight;
    FramesDocument frames;
    ImageDocument image;
    Shutter shutter;
    SamplingDocument sampling;
    LookDocument look;
    OutputDocument output;
    double motion_bound_px = 0.01;
};

// A batch document lists shots.
struct BatchDocument {
    std::filesystem::path file;
    std::vector<std::filesystem::path> shots;
};

}  // namespace overfly
