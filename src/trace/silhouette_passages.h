#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "trace/kinetic_log.h"
#include "trace/kinetic_piece.h"

namespace overfly {

// A line of sight that passes a silhouette edge.
struct SilhouettePassage {
    std::uint32_t sample = 0;
    double u = 0.0;
    HalfEdgeId half_edge = kNone;
    bool comes = false;  // to what is beside the edge; otherwise it leaves that
};

struct SilhouettePassages {
    // By sample, then in the order of time. At u the line has already come to what is beside the edge, or has not quite
    // left it, by whatever arithmetic.
    std::vector<SilhouettePassage> in_order;
    // Samples that begin so near to a silhouette that a ray in float can't tell on which side; some more than once.
    std::vector<std::uint32_t> begins_at_edge;
};

// Every passage of the samples within the stretch.
[[nodiscard]] SilhouettePassages silhouette_passages(const KineticPiece& piece, const PieceStretch& stretch,
                                                     std::span<const ImageSample> samples);

}  // namespace overfly
