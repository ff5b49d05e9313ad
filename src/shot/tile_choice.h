#pragma once

#include <span>

#include "core/time_range.h"
#include "shot/pixel_tile.h"
#include "trace/ray_scene.h"
#include "trace/sight.h"

namespace overfly {

// What a shot is traced with: lines of sight that are followed through time, samples that see instants, or both to
// choose from; nullptr: not at hand. The two numbers are those that the user takes for equally good.
struct TracerPair {
    const SightTracer* continuous = nullptr;
    int lines = 4;  // per pixel
    const SightTracer* discrete = nullptr;
    int samples = 64;  // per pixel
    // How far lines drift over the picture during an exposure; 0: they stand still. With it, what they see.
    double drift_px = 0.0;
    double error = 0.0;  // that drifting lines are added for until they reach it; 0: `lines` it is
    const RayScene* ground = nullptr;
};

// The hybrid of Chapman, Calvert and Dill 1991, section 6, by tile and motion piece: whether following `lines` of a
// tile through a prepared stretch is expected to cost less than `samples` for each of the exposures. A few lines are
// followed to see. The same for whoever asks, for it goes by what the walks meet and not by the clock. REQUIRES: both
// tracers are at hand; lines are the tile's own.
[[nodiscard]] bool lines_are_cheaper(const TracerPair& tracers, const PreparedSight& prepared,
                                     std::span<const ImageSample> lines, std::span<const TimeRange> exposures,
                                     TraceCounters& counters);

}  // namespace overfly
