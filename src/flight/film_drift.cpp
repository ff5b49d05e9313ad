#include "flight/film_drift.h"

#include <array>

namespace overfly {
namespace {

// (u - about) * rate * axis(u), with u^3 replaced by the quadratic nearest to it on [0, 1]: (48 u^2 - 18 u + 1) / 32.
QuadraticVector moved_along(const QuadraticVector& axis, double rate, double about) {
    const Vector<Scene> cubic = rate * axis.c2;
    const Vector<Scene> square = rate * (axis.c1 - about * axis.c2) + 1.5 * cubic;
    const Vector<Scene> linear = rate * (axis.c0 - about * axis.c1) - (18.0 / 32.0) * cubic;
    const Vector<Scene> constant = -(rate * about) * axis.c0 + (1.0 / 32.0) * cubic;
    return {constant, linear, square};
}

QuadraticVector operator+(const QuadraticVector& a, const QuadraticVector& b) {
    return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2};
}

constexpr std::array kParts = {&MotionPiece::origin, &MotionPiece::right, &MotionPiece::down, &MotionPiece::view,
                               &MotionPiece::to_sun};

}  // namespace

MotionPiece drifting(const MotionPiece& piece, const FilmDrift& drift) {
    const double duration_s = piece.when.duration_s();
    const double about = piece.u_at(drift.about_s);
    MotionPiece out = piece;
    out.view = out.view + moved_along(piece.right, drift.x_per_s * duration_s, about) +
               moved_along(piece.down, drift.y_per_s * duration_s, about);
    return out;
}

MotionPiece standing_still(const MotionPiece& piece, double time_s, TimeRange when) {
    const double u = piece.u_at(time_s);
    const auto at_rest = [u](const QuadraticVector& v) { return QuadraticVector{v.at(u), {}, {}}; };
    MotionPiece out = piece;
    out.when = when;
    for (const auto part : kParts) out.*part = at_rest(piece.*part);
    return out;
}

MotionPiece part_of(const MotionPiece& piece, TimeRange when) {
    const double from = piece.u_at(when.begin_s), length = when.duration_s() / piece.when.duration_s();
    MotionPiece out = piece;
    out.when = when;
    for (const auto part : kParts) {
        const QuadraticVector& v = piece.*part;
        out.*part = {v.at(from), length * (v.c1 + (2.0 * from) * v.c2), (length * length) * v.c2};
    }
    return out;
}

FilmPoint film_point(const MotionPiece& piece, double u, Point<Scene> p) {
    const Vector<Scene> right = piece.right.at(u), down = piece.down.at(u), view = piece.view.at(u);
    const Vector<Scene> to = p - piece.origin_at(u);
    // Cramer's rule for to = depth * (x * right + y * down + view).
    const double depth = dot(to, cross(right, down));
    return {dot(to, cross(down, view)) / depth, dot(to, cross(view, right)) / depth,
            depth / dot(view, cross(right, down))};
}

}  // namespace overfly
