#pragma once

#include "shot/line_pattern.h"

namespace overfly {

// How the picture changes from a place to the pixels beside it, and where what is seen there goes in an exposure.
struct PictureChange {
    double right = 0.0, down = 0.0;  // of light, for each pixel in that direction
    double motion_right_px = 0.0, motion_down_px = 0.0;
};

// Weighs along which axis lines had better drift. Along its way a line averages exactly; across it the pixel has but a
// few of them. So what counts is by how much lines that pass side by side disagree about an edge, and on how much of
// the picture. Let n be the edge's normal of unit length, m its motion in the exposure, d how far lines drift. Lines
// that are spread over a pixel across their way are spread over a = |n . across| of one across the edge, and while a
// line passes the pixel, 1/d of the exposure, it goes
//
//   l = |n . along - n . m / d|
//
// across it, by which it blurs the edge. Where the lines disagree, on a + l, their difference is g a / (a + l), g being
// the edge's height. The squares of that add up to g^2 a^2 / (a + l). An edge that moves across itself quickly is
// blurred either way: nothing is gained by drifting over it, and the drift is for those that stay where they are.
class DriftAxisChoice {
  public:
    // drift_px: in the exposure that motions are of.
    explicit DriftAxisChoice(double drift_px) : drift_px_(drift_px) {}

    void add(const PictureChange& change);
    // Downward if in doubt, as most pictures of ground want it; that is also from far to near, and a line that meets
    // the nearer needs no ray (kinetic.md).
    [[nodiscard]] DriftAxis best() const { return error_x_ < error_y_ ? DriftAxis::X : DriftAxis::Y; }

  private:
    double drift_px_;
    double error_x_ = 0.0, error_y_ = 0.0;  // squared, of lines along that axis, to any scale
};

}  // namespace overfly
