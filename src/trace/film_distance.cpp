#include "trace/film_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overfly {

// Where an edge appears, its function is zero, and it is linear in the film coordinates.
double film_distance_to_sides(const TriangleMesh& mesh, TriangleId triangle, const MotionPiece& piece,
                              const ImageSample& sample, double u) {
    const auto& corner = mesh.triangles[triangle];
    const Vector<Scene> direction = piece.direction_at(u, sample.x, sample.y);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
        const Vector<Scene> a = mesh.positions[corner[k]] - piece.origin_at(u);
        const Vector<Scene> b = mesh.positions[corner[(k + 1) % 3]] - piece.origin_at(u);
        const Vector<Scene> plane = cross(a, b);
        const double slope = std::hypot(dot(plane, piece.right.at(u)), dot(plane, piece.down.at(u)));
        nearest = std::min(nearest, std::abs(dot(plane, direction)) / slope);
    }
    return nearest;
}

}  // namespace overfly
