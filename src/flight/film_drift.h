#pragma once

#include "flight/motion.h"

namespace overfly {

// Image samples that move over the film at a steady rate (design 3.5), so that each of them also averages over the
// picture: at about_s a sample is at its own film point (x, y), else at (x, y) + (time - about_s) * rate. To the lines
// of sight that is one more motion of the camera.
struct FilmDrift {
    double x_per_s = 0.0, y_per_s = 0.0;  // in film coordinates
    double about_s = 0.0;
};

// The piece whose ray of film point (x, y) is the given piece's ray of the drifting sample. Quadratic again: of the
// cubic that it would be, the highest term is economised (Lanczos 1938), which moves the ray by less than 1/32 of what
// the drift over the piece and the second-order change of right and down make together. For a drift of 30 pixels and a
// camera that turns by 10 degrees in the piece: 0.02 pixels, in all surfaces alike.
[[nodiscard]] MotionPiece drifting(const MotionPiece& piece, const FilmDrift& drift);

// The piece as it is at one of its times, all through `when`.
[[nodiscard]] MotionPiece standing_still(const MotionPiece& piece, double time_s, TimeRange when);

// A part of the piece as a piece of its own: the same rays at the same times, up to rounding.
[[nodiscard]] MotionPiece part_of(const MotionPiece& piece, TimeRange when);

// The film point that a point of the scene is seen at.
struct FilmPoint {
    double x = 0.0, y = 0.0;
    double depth_m = 0.0;  // planar; not above 0: it isn't before the camera, and x and y say nothing
};
[[nodiscard]] FilmPoint film_point(const MotionPiece& piece, double u, Point<Scene> p);

}  // namespace overfly
