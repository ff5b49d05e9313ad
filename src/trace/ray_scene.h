#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/geometry.h"
#include "geo/frames.h"
#include "mesh/triangle_mesh.h"

namespace overfly {

// Sixteen rays in the layout that vector units like: one array per coordinate. Positions are relative to the scene's
// float_centre, so that floats keep their precision where the camera flies.
struct RayPacket {
    static constexpr std::size_t kSize = 16;
    template <class T>
    using Lane = std::array<T, kSize>;

    alignas(64) Lane<float> origin_x{}, origin_y{}, origin_z{};
    alignas(64) Lane<float> direction_x{}, direction_y{}, direction_z{};
    alignas(64) Lane<float> least{};         // depth from which on hits count
    alignas(64) Lane<std::int32_t> valid{};  // -1: trace this lane, 0: do not
    // Answers; triangle is kNone where nothing was hit.
    alignas(64) Lane<std::uint32_t> triangle{};
    alignas(64) Lane<float> depth{};                             // in lengths of the direction
    alignas(64) Lane<float> u{}, v{};                            // barycentric, of corners 1 and 2
    alignas(64) Lane<float> normal_x{}, normal_y{}, normal_z{};  // not normalised: twice the triangle's area long

    // origin: relative to the scene's float_centre.
    void aim(std::size_t lane, Vector<Scene> origin, Vector<Scene> direction, bool is_valid) {
        origin_x[lane] = static_cast<float>(origin.x);
        origin_y[lane] = static_cast<float>(origin.y);
        origin_z[lane] = static_cast<float>(origin.z);
        direction_x[lane] = static_cast<float>(direction.x);
        direction_y[lane] = static_cast<float>(direction.y);
        direction_z[lane] = static_cast<float>(direction.z);
        valid[lane] = is_valid ? -1 : 0;
    }
};

// What one ray found.
struct RayHit {
    TriangleId triangle = kNone;
    double distance = 0.0;  // in lengths of the direction
};

// The mesh as Embree sees it: single precision, static. Rays, packets and nearest-distance queries at one instant.
// The mesh must outlive it.
class RayScene {
  public:
    // float_centre: the place around which float precision matters most, the middle of the flight.
    RayScene(const TriangleMesh& mesh, Point<Scene> float_centre);
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    [[nodiscard]] const TriangleMesh& mesh() const;
    [[nodiscard]] Point<Scene> float_centre() const;
    // The longest side of any triangle, in metres.
    [[nodiscard]] double longest_side_m() const;

    // The nearest triangle with distance >= least. REQUIRES: least >= 0.
    [[nodiscard]] std::optional<RayHit> first_hit(Point<Scene> origin, Vector<Scene> direction,
                                                  double least = 0.0) const;
    [[nodiscard]] bool is_blocked(Point<Scene> origin, Vector<Scene> direction, double least = 0.0) const;
    // The same for the valid lanes of a packet of rays that run much alike.
    void first_hits(RayPacket& packet) const;
    // Bit i: whether lane i is valid and blocked. Leaves the packet's answers alone.
    [[nodiscard]] std::uint32_t blocked_lanes(const RayPacket& packet) const;

    // From a point to the nearest point of any triangle, in metres; infinity in an empty mesh.
    [[nodiscard]] double distance_m(Point<Scene> p) const;

  private:
    struct Embree;
    std::unique_ptr<Embree> embree_;
};

}  // namespace overfly
