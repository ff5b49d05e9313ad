#pragma once

#include <array>

#include "shot/bench_flight.h"

namespace overfly {

// What making the pixels of some frames took with one tracer: visibility, light and film, on one thread.
struct HybridTiming {
    TracerKind kind = TracerKind::Hybrid;
    double ns_per_pixel_frame = 0.0;
    double rmse = 0.0;  // of one of the frames against many samples, in shares of full scale (linear 1)
};

struct HybridBench {
    int width = 0, height = 0, frames = 0, lines = 0, samples = 0, reference_samples = 0;
    double share_by_lines = 0.0;          // of tiles and pieces, as the hybrid chose
    std::array<HybridTiming, 3> tracers;  // interval, discrete, hybrid
};

// The hybrid and the two that it chooses from at the same work: pieces spread evenly over the shot, each by one tracer
// after another.
[[nodiscard]] HybridBench bench_hybrid(const ShotDocument& shot, const BenchOptions& options);

}  // namespace overfly
