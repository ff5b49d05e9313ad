#include "trace/silhouette_film.h"

#include <algorithm>

namespace overfly {
namespace {

constexpr std::array<double, 3> kChoose2 = {1, 2, 1};
constexpr std::array<double, 5> kChoose4 = {1, 4, 6, 4, 1};
constexpr std::array<double, 7> kChoose6 = {1, 6, 15, 20, 15, 6, 1};

}  // namespace

FilmBounds film_bounds(std::span<const ImageSample> samples) {
    FilmBounds bounds = {samples[0].x, samples[0].x, samples[0].y, samples[0].y};
    for (const ImageSample& s : samples) {
        bounds = {std::min(bounds.low_x, s.x), std::max(bounds.high_x, s.x), std::min(bounds.low_y, s.y),
                  std::max(bounds.high_y, s.y)};
    }
    return bounds;
}

FilmCurves::FilmCurves(const MotionPiece& piece) {
    const auto to_view = cross_coefficients(piece.right, piece.down);
    // Negative in a picture turned over, as by a mirror.
    const double sign = dot(to_view[2], piece.view.at(0.5)) < 0.0 ? -1.0 : 1.0;
    x_ = curve(piece.origin, cross_coefficients(piece.down, piece.view), sign);
    y_ = curve(piece.origin, cross_coefficients(piece.view, piece.right), sign);
    depth_ = curve(piece.origin, to_view, sign);
}

FilmCurves::Curve FilmCurves::curve(const QuadraticVector& origin, const std::array<Vector<Scene>, 5>& direction,
                                    double sign) {
    const auto o = coefficients(origin);
    Curve curve;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 5; ++j) {
            const double weight = sign * kChoose2[i] * kChoose4[j] / kChoose6[i + j];
            curve.along[i + j] = curve.along[i + j] + weight * direction[j];
            curve.offset[i + j] += weight * dot(o[i], direction[j]);
        }
    }
    return curve;
}

FilmCurves::Place FilmCurves::place(Vector<Scene> point) const {
    Place place;
    std::array<double, 7> depth{};
    for (std::size_t k = 0; k < 7; ++k) depth[k] = dot(point, depth_.along[k]) - depth_.offset[k];
    const auto [least, most] = std::ranges::minmax(depth);
    if (most <= 0.0) place.depth = Place::Depth::Behind;
    if (least <= 0.0) return place;
    place.depth = Place::Depth::Before;
    for (std::size_t k = 0; k < 7; ++k) {
        const double x = (dot(point, x_.along[k]) - x_.offset[k]) / depth[k];
        const double y = (dot(point, y_.along[k]) - y_.offset[k]) / depth[k];
        if (k == 0) place.film = {x, x, y, y};
        place.film = {std::min(place.film.low_x, x), std::max(place.film.high_x, x), std::min(place.film.low_y, y),
                      std::max(place.film.high_y, y)};
    }
    return place;
}

}  // namespace overfly
