#include "trace/film_box.h"

#include <algorithm>
#include <limits>

#include "core/bernstein.h"
#include "core/parallel.h"
#include "core/rounded_float.h"

namespace overfly {
namespace {

constexpr std::size_t kVerticesPerTask = 8192;

// More than all roundings of a film place: positions of up to 1e6 m relative to the piece, 30 operations of 2^-53 each,
// a depth of a centimetre or more. A two-hundredth of a pixel.
constexpr double kWiden_film = 1e-5;
constexpr double kWiden_depth = 1e-9;  // relative

using VectorBernstein2 = std::array<Bernstein<2>, 3>;
using VectorBernstein4 = std::array<Bernstein<4>, 3>;

VectorBernstein2 bernstein(const QuadraticVector& q) {
    return {quadratic_over(q.c0.x, q.c1.x, q.c2.x, 0.0, 1.0), quadratic_over(q.c0.y, q.c1.y, q.c2.y, 0.0, 1.0),
            quadratic_over(q.c0.z, q.c1.z, q.c2.z, 0.0, 1.0)};
}

Bernstein<6> dot(const VectorBernstein2& a, const VectorBernstein4& b) {
    Bernstein<6> sum{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Bernstein<6> term = a[axis] * b[axis];
        for (std::size_t j = 0; j < 7; ++j) sum[j] += term[j];
    }
    return sum;
}

VectorBernstein4 cross(const VectorBernstein2& a, const VectorBernstein2& b) {
    VectorBernstein4 c{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t next = (axis + 1) % 3;
        const std::size_t last = (axis + 2) % 3;
        const Bernstein<4> plus = a[next] * b[last];
        const Bernstein<4> minus = a[last] * b[next];
        for (std::size_t j = 0; j < 5; ++j) c[axis][j] = plus[j] - minus[j];
    }
    return c;
}

// det(p - origin, a, b) for any point p, of two vectors of the camera.
struct Determinant {
    std::array<Bernstein<6>, 3> of_point{};  // a x b by axis, raised to degree six
    Bernstein<6> of_origin{};

    static constexpr Bernstein<2> kOne = {1.0, 1.0, 1.0};

    Determinant(const VectorBernstein2& origin, const VectorBernstein2& a, const VectorBernstein2& b) {
        const VectorBernstein4 normal = cross(a, b);
        for (std::size_t axis = 0; axis < 3; ++axis) of_point[axis] = kOne * normal[axis];
        of_origin = dot(origin, normal);
    }
    [[nodiscard]] Bernstein<6> at(Vector<Scene> p) const {
        Bernstein<6> value{};
        for (std::size_t j = 0; j < 7; ++j)
            value[j] = p.x * of_point[0][j] + p.y * of_point[1][j] + p.z * of_point[2][j] - of_origin[j];
        return value;
    }
};

Bernstein<6> sum(double a, const Bernstein<6>& of_a, double b, const Bernstein<6>& of_b) {
    Bernstein<6> c{};
    for (std::size_t j = 0; j < 7; ++j) c[j] = a * of_a[j] + b * of_b[j];
    return c;
}

bool all_positive(const Bernstein<6>& b) { return std::ranges::min(b) > 0.0; }

struct Range {
    double low, high;
};

// REQUIRES: all_positive(denominator).
Range ratio(const Bernstein<6>& numerator, const Bernstein<6>& denominator) {
    Range range = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (std::size_t j = 0; j < 7; ++j) {
        const double value = numerator[j] / denominator[j];
        range = {std::min(range.low, value), std::max(range.high, value)};
    }
    return range;
}

// What turns a point into a film place and a depth while a piece lasts.
struct FilmPlaces {
    Point<Scene> reference;
    Determinant x, y, depth;
    Bernstein<6> volume;  // of right, down and view: the denominator of the depth

    explicit FilmPlaces(const MotionPiece& piece)
        : FilmPlaces(piece.reference, bernstein(piece.origin), bernstein(piece.right), bernstein(piece.down),
                     bernstein(piece.view)) {}
    FilmPlaces(Point<Scene> at, const VectorBernstein2& origin, const VectorBernstein2& right,
               const VectorBernstein2& down, const VectorBernstein2& view)
        : reference(at),
          x(origin, down, view),
          y(origin, view, right),
          depth(origin, right, down),
          volume(dot(view, cross(right, down))) {}
};

}  // namespace

FilmBoxes::FilmBoxes(const TriangleMesh& mesh, const MotionPiece& piece, FilmReach reach)
    : mesh_(&mesh), reach_(reach), corners_(mesh.positions.size()) {
    const FilmPlaces places(piece);
    const auto corner_box = [&](VertexId v) {
        const Vector<Scene> p = mesh.positions[v] - places.reference;
        const Bernstein<6> x = places.x.at(p);
        const Bernstein<6> y = places.y.at(p);
        const Bernstein<6> facing = places.depth.at(p);
        CornerBox box;
        const auto stays = [&](unsigned where, const Bernstein<6>& distance) {
            if (all_positive(distance)) box.stays |= where;
        };
        const double x_reach = reach.x + kWiden_film;
        const double y_reach = reach.y + kWiden_film;
        stays(kBefore, facing);
        stays(kBehind, sum(-1.0, facing, 0.0, facing));
        stays(kLeft, sum(-1.0, x, -x_reach, facing));
        stays(kRight, sum(1.0, x, -x_reach, facing));
        stays(kAbove, sum(-1.0, y, -y_reach, facing));
        stays(kBelow, sum(1.0, y, -y_reach, facing));
        const auto set = [&](std::size_t axis, Range range, double widen) {
            box.low[axis] = rounded_down(range.low - widen);
            box.high[axis] = rounded_up(range.high + widen);
        };
        constexpr double kFarthest_m = std::numeric_limits<float>::max();
        const bool has_depth = all_positive(places.volume);
        const Range depth = has_depth ? ratio(facing, places.volume) : Range{0.0, kFarthest_m};
        set(2, depth, 0.0);
        if ((box.stays & kBefore) == 0) return box;
        set(0, ratio(x, facing), kWiden_film);
        set(1, ratio(y, facing), kWiden_film);
        return box;
    };
    const std::size_t tasks = (corners_.size() + kVerticesPerTask - 1) / kVerticesPerTask;
    parallel_for(tasks, [&](std::size_t task) {
        const std::size_t end = std::min(corners_.size(), (task + 1) * kVerticesPerTask);
        for (std::size_t v = task * kVerticesPerTask; v < end; ++v) corners_[v] = corner_box(static_cast<VertexId>(v));
    });
}

std::optional<FilmBox> FilmBoxes::of(TriangleId triangle) const {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    FilmBox box = {{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
    unsigned all_stay = ~0U;
    for (const VertexId v : mesh_->triangles[triangle]) {
        const CornerBox& corner = corners_[v];
        all_stay &= corner.stays;
        for (std::size_t k = 0; k < 3; ++k) {
            box.low[k] = std::min(box.low[k], static_cast<double>(corner.low[k]));
            box.high[k] = std::max(box.high[k], static_cast<double>(corner.high[k]));
        }
    }
    if ((all_stay & ~kBefore) != 0) return std::nullopt;
    const bool is_bounded = (all_stay & kBefore) != 0;
    const std::array<double, 2> reach = {reach_.x, reach_.y};
    for (std::size_t k = 0; k < 2; ++k) {
        box.low[k] = is_bounded ? std::max(box.low[k], -reach[k]) : -reach[k];
        box.high[k] = is_bounded ? std::min(box.high[k], reach[k]) : reach[k];
        if (box.low[k] > box.high[k]) return std::nullopt;
    }
    box.low[2] = std::max(0.0, box.low[2] * (1.0 - kWiden_depth));
    box.high[2] *= 1.0 + kWiden_depth;
    return box;
}

}  // namespace overfly
