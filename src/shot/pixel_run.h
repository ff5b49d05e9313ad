#pragma once

#include <algorithm>
#include <cstdint>

#include "shot/run_shares.h"

namespace overfly {

// The pixels that a line of sight passes during a run at an even speed: `count` of them from `first` on, `stride` apart
// in the film. The first ends at v = first_end, and each further one lasts v_per_pixel; all of the run has the weight.
// Or, where there are `shares`, what each pixel gets is what they say.
struct PixelRun {
    std::uint32_t film = 0, first = 0;
    std::int32_t stride = 1, count = 1;
    double first_end = 1.0, v_per_pixel = 0.0;
    double weight = 1.0;
    const RunShares* shares = nullptr;
};

// Calls with_pixel(pixel, from v, to v) for each of them that the run is in for a while. REQUIRES: no shares.
template <class WithPixel>
void for_each_pixel(const PixelRun& run, const WithPixel& with_pixel) {
    const auto first_end = static_cast<float>(run.first_end), v_per_pixel = static_cast<float>(run.v_per_pixel);
    float reached = 0.0F;
    for (int i = 0; i < run.count; ++i) {
        const bool is_last = i + 1 == run.count;
        const float end = is_last ? 1.0F : first_end + static_cast<float>(i) * v_per_pixel;
        if (end <= reached) continue;
        with_pixel(run.first + static_cast<std::uint32_t>(i * run.stride), reached, end);
        reached = end;
    }
}

}  // namespace overfly
