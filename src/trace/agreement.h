#pragma once

#include <cstdint>

#include "flight/motion.h"
#include "trace/discrete.h"
#include "trace/interval.h"

namespace overfly {

// How far two tracers tell the same story: at random places of the picture and random times of the flight, the triangle
// that one sees all through a stretch and the one that the other sees at that instant.
struct Agreement {
    long pairs = 0;
    long same = 0;         // the same triangle, or both the sky
    long same_depth = 0;   // another triangle, at a depth within kSameDepth of it
    long near_edge = 0;    // neither, but the point is within kNearEdge_px of an edge of one of the two
    long unexplained = 0;  // none of these

    [[nodiscard]] double same_share() const {
        return pairs > 0 ? static_cast<double>(same) / static_cast<double>(pairs) : 1.0;
    }
};

inline constexpr double kSameDepth = 1e-4;  // relative
inline constexpr double kNearEdge_px = 1e-3;

struct AgreementOptions {
    long pairs = 200'000;
    std::uint64_t seed = 1;
    int width_px = 960, height_px = 540;  // what a pixel is, and the shape of the picture
};

[[nodiscard]] Agreement compare(const DiscreteTracer& discrete, const IntervalTracer& interval,
                                const TriangleMesh& mesh, const Motion& motion, const AgreementOptions& options);

}  // namespace overfly
