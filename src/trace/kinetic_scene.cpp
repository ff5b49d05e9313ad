#include "trace/kinetic_scene.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace overfly {
namespace {

// A line of sight nearer to the plane of the picture's middle camera than this (78 degrees off) is not for floats.
constexpr double kLeastAhead = 0.2;

constexpr std::size_t kVerticesInTask = std::size_t{1} << 15U;

struct Axes {
    Vector<Scene> x, y, z;
    [[nodiscard]] std::array<double, 3> of(Vector<Scene> v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
};

Axes camera_axes(const MotionPiece& piece) {
    Axes axes;
    axes.z = normalized(piece.view.at(0.5));
    axes.y = normalized(cross(axes.z, piece.right.at(0.5)));
    axes.x = cross(axes.y, axes.z);
    return axes;
}

Quadratic3<float> in(const Axes& axes, const QuadraticVector& q) {
    Quadratic3<float> c{};
    const std::array parts = {axes.of(q.c0), axes.of(q.c1), axes.of(q.c2)};
    for (std::size_t power = 0; power < 3; ++power) {
        for (std::size_t axis = 0; axis < 3; ++axis) c[power][axis] = static_cast<float>(parts[power][axis]);
    }
    return c;
}

}  // namespace

Across::Across(const TriangleMesh& mesh) {
    const auto apex = [&](HalfEdgeId twin) { return twin != kNone ? mesh.triangles[twin / 4][(twin % 4 + 2) % 3] : 0; };
    apexes.reserve(mesh.twins.size());
    for (const auto& twins : mesh.twins) apexes.push_back({apex(twins[0]), apex(twins[1]), apex(twins[2])});
}

StrideScene::StrideScene(const TriangleMesh& terrain, const Across& beyond, const MotionPiece& piece)
    : mesh(&terrain), across(&beyond) {
    const Axes axes = camera_axes(piece);
    positions.resize(terrain.positions.size());
    parallel_for((positions.size() + kVerticesInTask - 1) / kVerticesInTask, [&](std::size_t i) {
        for (std::size_t v = i * kVerticesInTask; v < std::min((i + 1) * kVerticesInTask, positions.size()); ++v) {
            const auto c = axes.of(terrain.positions[v] - piece.reference);
            positions[v] = {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]), 0.0F};
        }
    });
    origin = in(axes, piece.origin);
    right = in(axes, piece.right);
    down = in(axes, piece.down);
    view = in(axes, piece.view);
    // (w - o' h - o2 h^2) x (d + d' h + d2 h^2), from h^3 on.
    const auto longest = [](const QuadraticVector& q) { return length(q.c1) + 2.0 * length(q.c2); };
    const double speed = longest(piece.origin);
    const double turn = longest(piece.right) + longest(piece.down) + longest(piece.view);
    const double bend = length(piece.right.c2) + length(piece.down.c2) + length(piece.view.c2);
    const double least = 1e-30;  // a camera at rest; something to divide by
    third_order_m = static_cast<float>(least + speed * bend + length(piece.origin.c2) * (turn + bend));
}

void StrideScene::set_front(std::span<const Facing> facing) {
    front.assign(facing.size() / 32 + 1, 0);
    for (std::size_t t = 0; t < facing.size(); ++t) {
        const std::uint32_t bit = facing[t] == Facing::Front ? 1 : 0;
        front[t / 32] |= bit << (t % 32);
    }
}

bool StrideScene::is_ahead(double x, double y) const {
    // Bernstein coefficients of what goes along z.
    const auto coefficients = [](const Quadratic3<float>& q) {
        const std::array<double, 3> c = {static_cast<double>(q[0][2]), static_cast<double>(q[1][2]),
                                         static_cast<double>(q[2][2])};
        return std::array{c[0], c[0] + 0.5 * c[1], c[0] + c[1] + c[2]};
    };
    const auto r = coefficients(right);
    const auto e = coefficients(down);
    const auto v = coefficients(view);
    for (std::size_t j = 0; j < 3; ++j) {
        if (v[j] - std::abs(x * r[j]) - std::abs(y * e[j]) < kLeastAhead) return false;
    }
    return true;
}

std::size_t StrideScene::memory_bytes() const {
    return positions.size() * sizeof(positions[0]) + front.size() * sizeof(front[0]);
}

}  // namespace overfly
