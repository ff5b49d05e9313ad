#include "trace/ray_scene.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <random>

#include "support/terrains.h"

namespace overfly {
namespace {

TEST(RayScene, APacketIsBlockedWhereItsRaysAre) {
    const TerrainMesh mesh = testing::heightfield(41, 41, 50.0, testing::rough_ground);
    const RayScene scene(mesh, {120.0, -70.0, 300.0});
    constexpr unsigned kSeed = 20;
    std::mt19937 random(kSeed);
    std::uniform_real_distribution<double> place_m(-900.0, 900.0), part(-0.5, 0.5);
    int blocked = 0, open = 0;
    for (int n = 0; n < 200; ++n) {
        RayPacket packet;
        std::array<bool, RayPacket::kSize> expected{};
        for (std::size_t lane = 0; lane < RayPacket::kSize; ++lane) {
            const double x = place_m(random), y = place_m(random);
            const Point<Scene> from = {x, y, testing::rough_ground(x, y) + 30.0};
            const Vector<Scene> direction = {part(random), part(random), part(random) + 0.3};
            const bool is_valid = (static_cast<std::size_t>(n) + lane) % 5 != 0;
            packet.aim(lane, from - scene.float_centre(), direction, is_valid);
            expected[lane] = is_valid && scene.is_blocked(from, direction);
            ++(expected[lane] ? blocked : open);
        }
        const std::uint32_t lanes = scene.blocked_lanes(packet);
        for (std::size_t lane = 0; lane < RayPacket::kSize; ++lane) {
            EXPECT_EQ(((lanes >> lane) & 1U) != 0U, expected[lane]) << "seed " << kSeed << ", packet " << n;
        }
    }
    EXPECT_GT(blocked, 500);
    EXPECT_GT(open, 500);
}

}  // namespace
}  // namespace overfly
