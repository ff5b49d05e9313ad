#pragma once

#include <filesystem>
#include <vector>

#include "config/documents.h"
#include "core/progress.h"
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
    double ns_per_sample = 0.0;
    TraceCounters counters;
};

struct BenchResult {
    int width = 0, height = 0, frames = 0;
    std::size_t triangles = 0;
    TracerTiming discrete, interval;
    VolumeComparison volumes;
    std::vector<SwollenBoxes> swollen;  // longer and longer, in the middle of the flight
    Agreement agreement;
};

// Both tracers at the same work in one process: pieces spread evenly over the shot, on every second tile of the
// picture, each piece by one tracer and then by the other, so that a change of the machine's speed meets both. The
// bounding volumes are compared on the same pieces.
[[nodiscard]] BenchResult bench_flight(const ShotDocument& shot, const BenchOptions& options);

}  // namespace overfly
