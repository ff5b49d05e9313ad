#pragma once

#include "core/polynomial_roots.h"
#include "trace/line.h"

namespace overfly {

// When a line of sight is on which side of an edge: by Bernstein coefficients over the piece, and their roots.
class EdgeSide {
  public:
    EdgeSide() = default;
    explicit EdgeSide(const Bernstein<4>& side);

    // 1 or -1 just after a time; 0 if the line is on the edge all through. A root counts as passed at itself.
    [[nodiscard]] double sign_after(double u) const;
    // The first root after a time, or infinity.
    [[nodiscard]] double next_root(double u) const;
    [[nodiscard]] double value(double u) const { return value_at<4>(side_, u); }
    [[nodiscard]] const Roots<4>& roots() const { return roots_; }

  private:
    Bernstein<4> side_{};
    Roots<4> roots_;
    double first_sign_ = 0.0;
};

// Where a line passes an edge: in depth, and along the edge in its length. Where it passes beside it, of the points of
// the edge's line that which it comes nearest to.
struct EdgePoint {
    double depth = 0.0, along = 0.0;
};
[[nodiscard]] EdgePoint edge_point(const TriangleMesh& mesh, HalfEdgeId half_edge, const Line& line);

}  // namespace overfly
