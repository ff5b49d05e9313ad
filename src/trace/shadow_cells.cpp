#include "trace/shadow_cells.h"

#include <algorithm>
#include <cmath>

#include "trace/plane_depth.h"

namespace overfly {
namespace {

// Further than anything, but finite when it is a float.
constexpr double kAnywhere_m = 1e30;
constexpr double kStill_rad = 1e-12;

template <std::size_t N>
constexpr Bernstein<N> ones() {
    Bernstein<N> b{};
    b.fill(1.0);
    return b;
}

template <std::size_t N>
void set(CellVectors<N>& vectors, std::size_t axis, std::size_t cell, const Bernstein<N>& b) {
    for (std::size_t j = 0; j <= N; ++j) vectors[axis][j][cell] = b[j];
}

std::array<Bernstein<2>, 3> over(const QuadraticVector& q, double from, double to) {
    return {quadratic_over(q.c0.x, q.c1.x, q.c2.x, from, to), quadratic_over(q.c0.y, q.c1.y, q.c2.y, from, to),
            quadratic_over(q.c0.z, q.c1.z, q.c2.z, from, to)};
}

QuadraticVector direction_of(const MotionPiece& m, double x, double y) {
    return {x * m.right.c0 + y * m.down.c0 + m.view.c0, x * m.right.c1 + y * m.down.c1 + m.view.c1,
            x * m.right.c2 + y * m.down.c2 + m.view.c2};
}

template <std::size_t kSunDegree>
std::array<Bernstein<kSunDegree>, 3> sun_over(const QuadraticVector& to_sun, double from, double to) {
    if constexpr (kSunDegree == 0) {
        const Vector<Scene> middle = to_sun.at(0.5);
        return {{{middle.x}, {middle.y}, {middle.z}}};
    } else {
        return over(to_sun, from, to);
    }
}

}  // namespace

bool sun_turns(const MotionPiece& motion) {
    const QuadraticVector& s = motion.to_sun;
    return length(s.c1) + length(s.c2) > kStill_rad * length(s.c0);
}

template <std::size_t kSunDegree>
ShadowCells<kSunDegree>::ShadowCells(const TriangleMesh& blocking, const MotionPiece& motion,
                                     std::span<const ShadowQuery> queries)
    : mesh(&blocking), piece(&motion) {
    seen.fill(kNone);
    for (std::size_t cell = 0; cell < queries.size(); ++cell) set_cell(cell, queries[cell]);
}

template <std::size_t kSunDegree>
void ShadowCells<kSunDegree>::set_cell(std::size_t cell, const ShadowQuery& query) {
    const auto [x, y, phase] = query.sample;
    const PlaneDepth depth(*query.mesh, query.triangle, *query.motion, x, y);
    const double seen_from = query.motion->u_at(query.when.begin_s);
    const double seen_to = query.motion->u_at(query.when.end_s);
    const Bernstein<2> n = depth.numerator_over(seen_from, seen_to);
    const Bernstein<2> w = depth.denominator_over(seen_from, seen_to);

    const double from = piece->u_at(query.when.begin_s);
    const double to = piece->u_at(query.when.end_s);
    const std::array<Bernstein<2>, 3> o = over(piece->origin, from, to);
    const std::array<Bernstein<2>, 3> d = over(direction_of(*piece, x, y), from, to);
    const std::array<Bernstein<kSunDegree>, 3> l = sun_over<kSunDegree>(piece->to_sun, from, to);

    const Bernstein<4> quartic_w = w * ones<2>();
    for (std::size_t j = 0; j < 5; ++j) weight[j][cell] = quartic_w[j];
    std::array<Bernstein<4>, 3> p;
    double sum = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Bernstein<4> ow = o[axis] * w;
        const Bernstein<4> nd = n * d[axis];
        for (std::size_t j = 0; j < 5; ++j) p[axis][j] = ow[j] + nd[j];
        for (const double c : p[axis]) sum += c;
        for (const double c : l[axis]) sum += c;
        set<4>(point, axis, cell, p[axis]);
        set<kSunDegree>(sun, axis, cell, l[axis]);
        set<kSide>(lines.direction, axis, cell, l[axis] * quartic_w);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t next = (axis + 1) % 3;
        const std::size_t last = (axis + 2) % 3;
        const Bernstein<kSide> plus = p[next] * l[last];
        const Bernstein<kSide> minus = p[last] * l[next];
        for (std::size_t j = 0; j <= kSide; ++j) lines.moment[axis][j][cell] = plus[j] - minus[j];
    }
    if (to - from > kBlink) blink[cell] = kBlink / (to - from);
    if (query.mesh == mesh) seen[cell] = query.triangle;
    bound_point(cell);
    // A point that is nowhere is in no shadow.
    if (std::isfinite(sum)) active |= 1U << cell;
}

// P is a mean of the places P_h,j / w_j of its control points as long as the w_j have one sign. Where w changes sign
// the point passes through infinity: then nobody sees it, or the line of sight runs within the triangle's plane.
template <std::size_t kSunDegree>
void ShadowCells<kSunDegree>::bound_point(std::size_t cell) {
    bool is_positive = true;
    bool is_negative = true;
    std::array<double, 5> per_weight;
    for (std::size_t j = 0; j < 5; ++j) {
        is_positive = is_positive && weight[j][cell] > 0.0;
        is_negative = is_negative && weight[j][cell] < 0.0;
        per_weight[j] = 1.0 / weight[j][cell];
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = kAnywhere_m;
        double high = -kAnywhere_m;
        for (std::size_t j = 0; j < 5; ++j) {
            const double place = point[axis][j][cell] * per_weight[j];
            low = std::min(low, place);
            high = std::max(high, place);
        }
        const bool is_bounded = (is_positive || is_negative) && low > -kAnywhere_m && high < kAnywhere_m;
        point_low[axis][cell] = is_bounded ? low : -kAnywhere_m;
        point_high[axis][cell] = is_bounded ? high : kAnywhere_m;
    }
    if (seen[cell] != kNone) bound_by_triangle(cell);
}

// Who sees a triangle of the mesh that stands in the light sees a point within it.
template <std::size_t kSunDegree>
void ShadowCells<kSunDegree>::bound_by_triangle(std::size_t cell) {
    const auto& corner = mesh->triangles[seen[cell]];
    std::array<Vector<Scene>, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = mesh->positions[corner[k]] - piece->reference;
    const std::array<std::array<double, 3>, 3> by_axis = {
        {{at[0].x, at[1].x, at[2].x}, {at[0].y, at[1].y, at[2].y}, {at[0].z, at[1].z, at[2].z}}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::ranges::minmax(by_axis[axis]);
        point_low[axis][cell] = std::clamp(point_low[axis][cell], low, high);
        point_high[axis][cell] = std::clamp(point_high[axis][cell], low, high);
    }
}

template struct ShadowCells<0>;
template struct ShadowCells<2>;

}  // namespace overfly
