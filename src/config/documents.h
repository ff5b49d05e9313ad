#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/error.h"
#include "core/local_time.h"
#include "film/frame_storage.h"
#include "film/layers.h"
#include "film/pixel_filter.h"
#include "film/preview_style.h"
#include "flight/body_motion.h"
#include "flight/body_path.h"
#include "flight/body_shape.h"
#include "flight/flight_clock.h"
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

// How the terrain's shadows on itself come about. All others, of bodies and on bodies, are Exact in any case.
enum class SunShadows {
    Baked,  // at the corners of the terrain's triangles, once for all times
    Exact,  // towards the sun from what a pixel sees, at all times of the exposure
};

struct LookDocument {
    std::filesystem::path colours;  // a GDAL colour-relief file; empty: the built-in ramp
    Look look;
    SunShadows sun_shadows = SunShadows::Baked;
};

struct FramesDocument {
    int first = 1;             // number of the first frame
    std::optional<int> count;  // none: as many as the flight lasts
    FrameRate rate;
    double start_s = 0.0;               // flight time of the first frame, from the flight's first keyframe
    std::optional<LocalTime> date{};    // at the flight's first keyframe, for headers
    std::vector<FlightSpeed> speeds{};  // by ascending frame; none: 1
};

struct ImageDocument {
    int width = 960, height = 540;
    bool transparent_sky = false;
    FilterKind filter = FilterKind::Box;
    std::optional<double> filter_width_px{};  // none: usual_width_px
};

struct SamplingDocument {
    TracerKind tracer = TracerKind::Kinetic;
    int lines = 2;          // per pixel: continuous tracers
    double drift_px = 8.0;  // how far a line moves over the picture during an exposure; 0: not at all
    double error = 0.0;     // of drifting lines, root mean square in linear light; 0: as many as `lines`
    int samples = 64;       // per pixel: the discrete tracer
    int mirror_depth = 1;   // how many mirrors a ray is followed through, one after another
};

struct OutputDocument {
    std::filesystem::path folder;
    std::string name;  // frames are NAME.0001.exr
    bool contact_sheet = true;
    bool movie = true;
    FrameStorage storage;
    bool layer_files = false;  // a file for each layer, NAME.LAYER.0001.exr, beside the beauty's
    PreviewStyle preview;      // of the contact sheet and the movie
};

// A body in a shot. The motion of one with an outline is its place, at rest.
struct BodyDocument {
    std::string name;  // no other body has it
    BodyShape shape;
    BodyMotion motion;
    Rgb albedo{0.5F, 0.5F, 0.5F};
    double mirror = 0.0;  // share of the light that it mirrors, 0 to 1; polygons and outlines are then planar
    bool shadow = true;   // draws one
    std::filesystem::path flight_file;  // that it follows, or empty
    BodyPlaces places;
};

// Which ground is of what kind, for the layers `id` and `cryptomatte`.
struct ClassesDocument {
    std::filesystem::path raster;  // a file, or a name that only GDAL understands
    int band = 1;
    std::map<int, std::string> names{};  // by value, at least 0; a value that has none is called by its digits
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
    std::vector<BodyDocument> bodies;
    LayerSet layers{};  // beside R, G, B, A and Z
    std::optional<ClassesDocument> classes{};
    OutputDocument output;
    double motion_bound_px = 0.01;
    double mesh_pixel_error = 0.5;  // 0: every sample
    double memory_gb = 4.0;         // that a render may take, 10^9 bytes each
};

// A batch document lists shots.
struct BatchDocument {
    std::filesystem::path file;
    std::vector<std::filesystem::path> shots;
};

}  // namespace overfly
