#pragma once

#include <vector>

#include "flight/motion.h"
#include "shot/expose_piece.h"
#include "shot/line_pattern.h"

namespace overfly {

// A stretch of the picture, rows and columns alike, in which all lines drift the same way.
inline constexpr int kDriftTileSide_px = 64;

// How many of them there are along a side of the picture; the last may be cut.
[[nodiscard]] constexpr int drift_tiles_along(int side_px) {
    return (side_px + kDriftTileSide_px - 1) / kDriftTileSide_px;
}

// Tiles beside each other along the way that lines drift, in all of them: they are followed from one to the next.
struct DriftField {
    PixelTile pixels;
    DriftAxis axis = DriftAxis::Y;
};

// The picture, as far as it is wanted, in fields whose lines drift all through a piece along the axis that leaves less
// error (DriftAxisChoice): as the ground looks in the middle of the piece, for exposures as long as the planned ones.
// Single tiles where each is to reach an error of its own. REQUIRES: exposing has drift.
[[nodiscard]] std::vector<DriftField> drift_fields(const Exposing& exposing, const MotionPiece& piece);

}  // namespace overfly
