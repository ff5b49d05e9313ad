#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "trace/kinetic_log.h"
#include "trace/kinetic_piece.h"

namespace overfly {

// A line of sight that passes a silhouette edge. At u the line has already come to what is beside the edge, or has not
// quite left it, by whatever arithmetic.
struct SilhouettePassage {
    std::uint32_t sample = 0, silhouette = 0;
    double u = 0.0;
    double doubt_u = 0.0;  // a guess is off by less than this
    HalfEdgeId half_edge = kNone;
    bool comes = false;  // to what is beside the edge; otherwise it leaves that
    // Of a guess `comes` is open, and it is so far from the sample's other passages that their order is certain. One
    // that turns out to be beside the edge is None.
    enum class State : std::uint8_t { Exact, Guess, None } state = State::Exact;

    // Surely.
    [[nodiscard]] bool is_after(double time_u) const { return u - doubt_u > time_u; }
};

struct SilhouettePassages {
    std::vector<SilhouettePassage> in_order;  // by sample, then in the order of time
    // Samples that begin so near to a silhouette that a ray in float can't tell on which side; some more than once.
    std::vector<std::uint32_t> begins_at_edge;
};

// Every passage of the samples within the stretch, and some from just before and after; most are guesses.
// GUARANTEES: those until shortly after a time are the same to the bit whenever the stretch ends after it.
[[nodiscard]] SilhouettePassages silhouette_passages(const KineticPiece& piece, const PieceStretch& stretch,
                                                     std::span<const ImageSample> samples);

// Makes of a guess what it is.
void resolve(const KineticPiece& piece, const ImageSample& sample, SilhouettePassage& passage);

}  // namespace overfly
