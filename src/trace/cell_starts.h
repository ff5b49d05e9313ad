#pragma once

#include "trace/plane_depth.h"
#include "trace/ray_start.h"
#include "trace/stretches.h"
#include "trace/swept_ray.h"

namespace overfly {

// A start excludes what is met no further beyond it than this, as a share of its depth: what lies in the mirror's plane
// itself, a lake among the triangles of a terrain, is met at the start but for some ten roundings over the sine of the
// angle with the plane.
inline constexpr double kAtStart = 1e-9;

// Where the rays of a walk begin to look, cell by cell: at s_m(u) = numerator / denominator, both quadratic in the
// cell's time.
class CellStarts {
  public:
    // For the cells in use. REQUIRES: start.motion holds their times.
    CellStarts(const RayStart& start, const SweptRays& rays);

    // Those in which rays start at some time: s_m is positive and finite.
    [[nodiscard]] std::uint32_t open() const { return open_; }
    // No ray of the cell starts nearer than this.
    [[nodiscard]] float nearest(std::size_t cell) const { return nearest_[cell]; }

    // Four crossings with the plane of a triangle, and twice two zeros of each of the start's parts and of what the
    // triangle's depth is divided by.
    using Parts = Stretches<10 / 2 + 1>;
    // When the rays start before they meet a plane: the parts of `stretch` in which s_m is positive and finite and the
    // plane's depth (both parts over the cell) greater.
    [[nodiscard]] Parts before(const Bernstein<2>& numerator, const Bernstein<2>& denominator, std::size_t cell,
                               Stretch stretch) const;

  private:
    [[nodiscard]] bool starts(std::size_t cell, double u) const;

    PerCell<Bernstein<2>> numerator_{}, denominator_{};
    PerCell<float> nearest_{};
    std::uint32_t open_ = 0;
};

}  // namespace overfly
