#pragma once

#include <array>
#include <optional>
#include <vector>

#include "flight/motion.h"
#include "mesh/triangle_mesh.h"

namespace overfly {

// Film places and depths in which a triangle stays all through a motion piece: x, y (flight/motion.h) and planar depth
// in metres.
struct FilmBox {
    std::array<double, 3> low, high;
};

// The part of the film that matters: |x| and |y| at most these.
struct FilmReach {
    double x = 1.0, y = 1.0;
};

// The paper's bounding volumes (Chapman, Calvert and Dill 1991, section 3: "created so as to contain the object at all
// times") for a scene wholly in relative motion, which they swell with. In the frame of the camera a ray stands still;
// boxes in film coordinates suit such rays better than boxes in metres would, since all that pass a film point pass it
// straight along depth.
// A corner's film place is rational in the time u of the piece: with r, d, v = right, down, view and y = p - origin,
//     x = det(y, d, v) / det(r, d, y),  y = det(r, y, v) / det(r, d, y),  depth = det(r, d, y) / det(r, d, v),
// all of degree six; it lies between the least and the greatest ratio of Bernstein coefficients while the denominators'
// are of one sign (Farouki 2012: they are the weights of control points). Where that of x and y is not, the corner
// passes the camera's plane, and the box has the whole film; unless all corners stay beyond one edge of it, which is
// again a sign, that of det(y, d, v) - x det(r, d, y).
class FilmBoxes {
  public:
    // The mesh must outlive this.
    FilmBoxes(const TriangleMesh& mesh, const MotionPiece& piece, FilmReach reach);

    // Cut off at the reach. None: the triangle stays behind the camera, or beyond the reach.
    [[nodiscard]] std::optional<FilmBox> of(TriangleId triangle) const;

  private:
    // Half-spaces that a corner doesn't leave, bits of a set.
    static constexpr unsigned kBefore = 1, kBehind = 2, kLeft = 4, kRight = 8, kAbove = 16, kBelow = 32;
    struct CornerBox {
        std::array<float, 3> low{}, high{};  // of x and y only if kBefore
        unsigned stays = 0;
    };

    const TriangleMesh* mesh_;
    FilmReach reach_;
    std::vector<CornerBox> corners_;  // by vertex
};

}  // namespace overfly
