#include "flight/motion.h"

#include <algorithm>

namespace overfly {

const MotionPiece& Motion::piece_at(double time_s) const {
    const auto later = std::upper_bound(pieces.begin() + 1, pieces.end(), time_s,
                                        [](double t, const MotionPiece& piece) { return t < piece.when.begin_s; });
    return *(later - 1);
}

std::span<const MotionPiece> Motion::pieces_over(TimeRange when) const {
    const auto begin = std::lower_bound(pieces.begin(), pieces.end(), when.begin_s,
                                        [](const MotionPiece& piece, double t) { return piece.when.end_s < t; });
    const auto end = std::upper_bound(begin, pieces.end(), when.end_s,
                                      [](double t, const MotionPiece& piece) { return t < piece.when.begin_s; });
    return {begin, end};
}

}  // namespace overfly
