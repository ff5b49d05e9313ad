#include "flight/image_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overfly {
namespace {

// Coordinates of a vector along a camera's right, down and view.
struct FilmCoordinates {
    explicit FilmCoordinates(const RayFrame& frame)
        : along_right(cross(frame.down, frame.view)),
          along_down(cross(frame.view, frame.right)),
          along_view(cross(frame.right, frame.down)) {
        const double volume = dot(along_right, frame.right);
        along_right = along_right / volume;
        along_down = along_down / volume;
        along_view = along_view / volume;
    }
    [[nodiscard]] Vector<Camera> of(Vector<Scene> v) const {
        return {dot(along_right, v), dot(along_down, v), dot(along_view, v)};
    }
    Vector<Scene> along_right, along_down, along_view;
};

// The ground point at parameter s of the exact ray is seen by the fitted camera at the film point of
// (x, y, 1) + shift, shift = turned + moved / s: the film moves by this much.
double film_distance(double x, double y, Vector<Camera> shift) {
    const double depth = 1.0 + shift.z;
    if (!(depth > 0.0)) return std::numeric_limits<double>::infinity();
    return std::hypot(shift.x - x * shift.z, shift.y - y * shift.z) / depth;
}

}  // namespace

double image_error(const RayFrame& exact, const RayFrame& fitted, double half_height, Reach reach) {
    const FilmCoordinates film(fitted);
    const Vector<Camera> moved = film.of(exact.origin - fitted.origin);
    const Vector<Camera> right = film.of(exact.right - fitted.right), down = film.of(exact.down - fitted.down),
                         view = film.of(exact.view - fitted.view);
    constexpr int kHalf = 2;  // points on either side of the middle
    double largest = 0.0;
    for (int row = -kHalf; row <= kHalf; ++row)
        for (int column = -kHalf; column <= kHalf; ++column) {
            const double x = static_cast<double>(column) / kHalf, y = half_height * row / kHalf;
            const Vector<Camera> turned = x * right + y * down + view;
            // The error is monotone or convex in 1/s but for 1 + shift.z, so the ends of what 1/s reaches decide.
            const double metres_per_depth = length(x * exact.right + y * exact.down + exact.view);
            const double nearest_per_s = metres_per_depth / reach.nearest_m;
            const double farthest_per_s = metres_per_depth / reach.farthest_m;
            largest = std::max({largest, film_distance(x, y, turned + farthest_per_s * moved),
                                film_distance(x, y, turned + nearest_per_s * moved)});
        }
    return largest;
}

}  // namespace overfly
