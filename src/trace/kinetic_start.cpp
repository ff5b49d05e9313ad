#include "trace/kinetic_start.h"

#include <algorithm>
#include <array>

namespace overfly {
namespace {

// One axis of the rays: x * right + y * down + view.
void aim(const RayPacket::Lane<float>& x, const RayPacket::Lane<float>& y, std::array<double, 3> parts,
         RayPacket::Lane<float>& direction) {
    const auto right = static_cast<float>(parts[0]);
    const auto down = static_cast<float>(parts[1]);
    const auto view = static_cast<float>(parts[2]);
    for (std::size_t i = 0; i < RayPacket::kSize; ++i) direction[i] = x[i] * right + y[i] * down + view;
}

}  // namespace

void look_roughly(const RayScene& scene, const MotionPiece& piece, double u, std::span<const ImageSample> samples,
                  std::span<TriangleId> seen) {
    const Vector<Scene> origin = piece.origin_at(u) - scene.float_centre();
    const Vector<Scene> right = piece.right.at(u);
    const Vector<Scene> down = piece.down.at(u);
    const Vector<Scene> view = piece.view.at(u);
    RayPacket packet;
    packet.origin_x.fill(static_cast<float>(origin.x));
    packet.origin_y.fill(static_cast<float>(origin.y));
    packet.origin_z.fill(static_cast<float>(origin.z));
    RayPacket::Lane<float> x{};
    RayPacket::Lane<float> y{};
    for (std::size_t first = 0; first < samples.size(); first += RayPacket::kSize) {
        const std::size_t count = std::min(RayPacket::kSize, samples.size() - first);
        for (std::size_t i = 0; i < RayPacket::kSize; ++i) {
            const ImageSample& s = samples[first + (i < count ? i : 0)];
            x[i] = static_cast<float>(s.x);
            y[i] = static_cast<float>(s.y);
            packet.valid[i] = i < count ? -1 : 0;
        }
        aim(x, y, {right.x, down.x, view.x}, packet.direction_x);
        aim(x, y, {right.y, down.y, view.y}, packet.direction_y);
        aim(x, y, {right.z, down.z, view.z}, packet.direction_z);
        scene.first_hits(packet);
        std::copy_n(packet.triangle.begin(), count, seen.begin() + static_cast<std::ptrdiff_t>(first));
    }
}

}  // namespace overfly
