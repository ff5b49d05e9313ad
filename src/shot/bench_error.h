#pragma once

#include <vector>

#include "core/progress.h"
#include "shot/bench_scene.h"

namespace overfly {

// How far a picture is from the truth, and what it took: light and film included, processor time of one frame.
struct ErrorPoint {
    int count = 0;          // of samples, or of lines, a pixel
    double drift_px = 0.0;  // of lines
    double rmse = 0.0;
    double seconds = 0.0;
};

// The quickest lines that are at least as near to the truth as so many samples.
struct EqualError {
    ErrorPoint discrete, kinetic;

    [[nodiscard]] double ratio() const { return discrete.seconds / kinetic.seconds; }
};

struct ErrorBench {
    int reference_samples = 0;
    std::vector<ErrorPoint> discrete, kinetic;  // with the shot's drift
    std::vector<ErrorPoint> other_drifts;
    std::vector<EqualError> equal;
};

// A frame in the middle of the shot, on one thread, against many samples. The error is that of some tiles spread evenly
// over the picture; the discrete tracer is timed on those. The kinetic one prepares whole pieces of the flight, so it
// is timed on all frames of a piece in the middle, for one frame on average.
[[nodiscard]] ErrorBench bench_error(const BenchScene& scene, const Progress& progress);

}  // namespace overfly
