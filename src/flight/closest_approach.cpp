#include "flight/closest_approach.h"

#include <algorithm>

#include <fmt/format.h>

namespace overfly {
namespace {

// Times of a piece at which the lens is looked at. It zooms smoothly, and a piece is short.
constexpr int kLooks = 8;

// Of a sight that turns by an angle, in a corner of the picture: on a plane at distance 1 a point at slope s from the
// middle moves 1 + s^2 as far as one in the middle, if it moves outward.
double pixels_per_radian(double tan_half_fov, PicturePixels picture) {
    const double shape = static_cast<double>(picture.height) / picture.width;
    const double slope2 = tan_half_fov * tan_half_fov * (1.0 + shape * shape);
    return 0.5 * picture.width / tan_half_fov * (1.0 + slope2);
}

double distance_to_segment(Point<Scene> p, Point<Scene> from, Point<Scene> to) {
    const Vector<Scene> along = to - from;
    const double length2 = dot(along, along);
    const double share = length2 > 0.0 ? std::clamp(dot(p - from, along) / length2, 0.0, 1.0) : 0.0;
    return distance(p, from + share * along);
}

}  // namespace

ClosestApproach::ClosestApproach(const Motion& motion, PicturePixels picture) {
    for (const MotionPiece& piece : motion.pieces) {
        // A quadratic is at most a quarter of its second coefficient off its chord.
        Stretch stretch = {piece.origin_at(0.0), piece.origin_at(1.0), 0.25 * length(piece.origin.c2), 0.0};
        for (int k = 0; k <= kLooks; ++k) {
            const double tan_half_fov = length(piece.right.at(static_cast<double>(k) / kLooks));
            stretch.pixels_per_radian = std::max(stretch.pixels_per_radian, pixels_per_radian(tan_half_fov, picture));
        }
        stretches_.push_back(stretch);
    }
}

double ClosestApproach::pixels_per_metre(Point<Scene> middle, double radius_m) const {
    double most = 0.0;
    for (const Stretch& s : stretches_) {
        const double clear_m = distance_to_segment(middle, s.from, s.to) - s.stray_m - radius_m;
        most = std::max(most, s.pixels_per_radian / std::max(clear_m, kNearest_m));
    }
    return most;
}

std::string ClosestApproach::text() const {
    std::string text;
    for (const Stretch& s : stretches_) {
        text += fmt::format("{} {} {} {} {} {} {} {}\n", s.from.x, s.from.y, s.from.z, s.to.x, s.to.y, s.to.z,
                            s.stray_m, s.pixels_per_radian);
    }
    return text;
}

}  // namespace overfly
