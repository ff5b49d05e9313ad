#pragma once

#include <array>
#include <span>

#include "trace/kinetic_line.h"
#include "trace/visible_segment.h"

namespace overfly {

// A part of the film, in film coordinates (flight/motion.h).
struct FilmBounds {
    double low_x = 0.0, high_x = 0.0, low_y = 0.0, high_y = 0.0;

    [[nodiscard]] bool overlaps(const FilmBounds& o) const {
        return low_x <= o.high_x && o.low_x <= high_x && low_y <= o.high_y && o.low_y <= high_y;
    }
};

// The smallest that has all of the samples. REQUIRES: at least one.
[[nodiscard]] FilmBounds film_bounds(std::span<const ImageSample> samples);

// Where points of the scene appear on the film while a motion piece lasts. With w from the camera to the point, film x
// is w.(down x view) / w.(right x down) and y is w.(view x right) / w.(right x down): ratios of polynomials of degree
// 6, whose Bernstein coefficients bound them where the denominator's are positive (Farin 2002, "Curves and Surfaces for
// CAGD", section 13.3: a rational curve with positive weights lies within its control points' hull).
class FilmCurves {
  public:
    explicit FilmCurves(const MotionPiece& piece);

    // Of a point relative to the piece's reference.
    struct Place {
        enum class Depth { Before, Behind, Both } depth = Depth::Both;  // of the camera, all through or not surely
        FilmBounds film;                                                // if before
    };
    [[nodiscard]] Place place(Vector<Scene> point) const;

  private:
    // point . along - offset, coefficient by coefficient.
    struct Curve {
        std::array<Vector<Scene>, 7> along{};
        std::array<double, 7> offset{};
    };
    [[nodiscard]] static Curve curve(const QuadraticVector& origin, const std::array<Vector<Scene>, 5>& direction,
                                     double sign);

    Curve x_, y_, depth_;
};

}  // namespace overfly
