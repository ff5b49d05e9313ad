#include "shot/drifting_sight.h"

namespace overfly {
namespace {

// Every motion of the sight, and of those in its mirrors, replaced.
template <class NewMotion>
Sight with_motions(const Sight& sight, const NewMotion& new_motion) {
    Sight out;
    out.in_mirror = sight.in_mirror;
    for (const Motion& m : sight.motions) out.motions.push_back(new_motion(m));
    for (const Sight& s : sight.mirrored) out.mirrored.push_back(with_motions(s, new_motion));
    return out;
}

}  // namespace

Sight drifting(const Sight& sight, TimeRange when, const FilmDrift& drift) {
    return with_motions(sight, [&](const Motion& motion) {
        Motion out = {{}, motion.bound_px, motion.largest_error_px};
        for (const MotionPiece& piece : motion.pieces_over(when)) out.pieces.push_back(drifting(piece, drift));
        return out;
    });
}

Sight standing_still(const Sight& sight, double time_s, TimeRange when) {
    return with_motions(sight, [&](const Motion& motion) {
        return Motion{
            {standing_still(motion.piece_at(time_s), time_s, when)}, motion.bound_px, motion.largest_error_px};
    });
}

Sight during(const Sight& sight, TimeRange when) {
    return with_motions(sight, [&](const Motion& motion) {
        Motion out = {{}, motion.bound_px, motion.largest_error_px};
        for (const MotionPiece& piece : motion.pieces_over(when))
            out.pieces.push_back(part_of(piece, intersection(piece.when, when)));
        return out;
    });
}

}  // namespace overfly
