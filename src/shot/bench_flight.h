#pragma once

#include <filesystem>
#include <vector>

#include "config/documents.h"
#include "core/progress.h"
#include "shot/bench_error.h"
#include "shot/bench_volumes.h"
#include "trace/agreement.h"

namespace overfly {

struct BenchOptions {
    long agreement_pairs = 200'000;
    std::filesystem::path cache_folder;
    Progress progress;
};

// One visibility sample of a pixel in a frame, no shading, on one thread.
struct TracerTiming {
    double ns_per_sample = 0.0;  // what a piece takes to prepare included, shared by one line for each pixel
    TraceCounters counters;
};

// Whole frames, light and film included, wall time.
struct ThreadTiming {
    int threads = 1;
    double seconds = 0.0;
};

// The kinetic tracer's visibility at a multiple of the shot's frame rate, lines at rest.
struct RateCost {
    int factor = 1;
    double ns_per_pixel_second = 0.0;  // of the flight
};

// One frame from its lines (ErrorPoint) to its file on one thread, and what compressing and writing that file takes.
struct EndToEnd {
    int lines = 0;
    double expose_s = 0.0, write_s = 0.0;

    [[nodiscard]] double ratio() const { return (expose_s + write_s) / write_s; }
};

struct BenchResult {
    int width = 0, height = 0, frames = 0;
    std::size_t timed_pieces = 0;
    std::size_t full_triangles = 0, triangles = 0;  // before and after the mesh was fit to the flight
    TracerTiming discrete, interval, kinetic;
    VolumeComparison volumes;
    std::vector<SwollenBoxes> swollen;  // longer and longer, in the middle of the flight
    Agreement agreement;                // of the interval tracer and discrete rays
    TraceCounters kinetic_check;        // of the kinetic tracer and discrete rays
    ErrorBench error;
    std::vector<ThreadTiming> threads;
    std::vector<RateCost> frame_rate_cost;
    EndToEnd end_to_end;
};

// The tracers at the same work in one process: pieces spread evenly over the shot, on every second tile of the
// picture, each piece by one tracer and then by the others, so that a change of the machine's speed meets all. The
// bounding volumes are compared on the same pieces.
[[nodiscard]] BenchResult bench_flight(const ShotDocument& shot, const BenchOptions& options);

}  // namespace overfly
