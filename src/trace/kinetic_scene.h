#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "flight/motion.h"
#include "mesh/triangle_mesh.h"
#include "trace/silhouette.h"

namespace overfly {

// What lies across each side of each triangle: the neighbour's corner that is not on the side; any vertex where there
// is no neighbour. Who walks on needs it at once, not after having found out which side of the neighbour it is.
struct Across {
    explicit Across(const TriangleMesh& mesh);

    std::vector<std::array<VertexId, 3>> apexes;
};

// A quadratic vector of u by its coefficients, c[power][axis].
template <class T>
using Quadratic3 = std::array<std::array<T, 3>, 3>;

// The mesh and the camera's motion as the vector units take them: single precision, in a frame that stands at the
// piece's reference with z along the view in the middle of the piece, x along the picture's right, y towards its
// bottom. Relative to the camera's distance a coordinate is off by 2^-24: 1e-4 of a pixel in a picture 1920 wide.
struct StrideScene {
    StrideScene(const TriangleMesh& terrain, const Across& beyond, const MotionPiece& piece);
    void set_front(std::span<const Facing> facing);

    const TriangleMesh* mesh;
    const Across* across;
    std::vector<std::array<float, 4>> positions;  // by vertex; the fourth is unused
    std::vector<std::uint32_t> front;             // a bit for each triangle that is Facing::Front
    Quadratic3<float> origin{};
    Quadratic3<float> right{}, down{}, view{};
    float third_order_m = 0.0F;  // where a point is beside a line, at u + h: no more than this h^3 beyond second order

    // Whether lines of sight through the film, at (x, y) up to these, keep well ahead of the plane z = 0.
    [[nodiscard]] bool is_ahead(double x, double y) const;
    [[nodiscard]] bool is_front(TriangleId t) const { return (front[t / 32] >> (t % 32) & 1U) != 0; }
    [[nodiscard]] std::size_t memory_bytes() const;
};

}  // namespace overfly
