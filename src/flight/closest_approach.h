#pragma once

#include <string>
#include <vector>

#include "flight/motion.h"

namespace overfly {

// The picture that a flight is seen in.
struct PicturePixels {
    int width = 960, height = 540;
};

// How large a metre becomes in the picture at most, as the camera comes by. Nothing is said of where it looks: what is
// behind it now may be in a mirror, or throw a shadow.
class ClosestApproach {
  public:
    static constexpr double kNearest_m = 0.01;  // as for fit_motion

    // REQUIRES: the motion has a piece.
    ClosestApproach(const Motion& motion, PicturePixels picture);

    // Pixels that a metre has at most, whatever its direction and wherever in the picture, at any time of the motion
    // and any point of a ball. What is nearer than kNearest_m counts as that far away. Through a mirror the way is
    // longer, and a metre smaller. GUARANTEES: never too small, but for 1e-3 of it while the lens zooms.
    [[nodiscard]] double pixels_per_metre(Point<Scene> middle, double radius_m = 0.0) const;

    // All that the answers depend on.
    [[nodiscard]] std::string text() const;

  private:
    // Where the camera is during a piece: on a straight line, but for stray_m.
    struct Stretch {
        Point<Scene> from, to;
        double stray_m = 0.0;
        double pixels_per_radian = 0.0;  // at most
    };

    std::vector<Stretch> stretches_;
};

}  // namespace overfly
