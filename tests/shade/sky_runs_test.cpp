#include "shade/sky_runs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "shade/plain_view.h"
#include "support/motions.h"

namespace overfly {
namespace {

constexpr float kDepth = 7.0F;

// Over a plain, looking at the horizon and rising from there while the piece lasts.
struct View : testing::PlainView {
    MotionPiece scene = [] {
        MotionPiece out = testing::HandMotion{{0, 0, 4000}, {0, 90, 0}, 0.3, 0.0, 0.0}.piece();
        out.view.c1 = {0.0, 0.0, 0.3};
        return out;
    }();

    [[nodiscard]] SkyRuns followed(std::span<const SkyRuns::Run> runs) const {
        SkyRuns out(scene, day, light, kDepth);
        for (const SkyRuns::Run& run : runs) out.add(run);
        out.follow();
        return out;
    }
};

// y is downward: high above the horizon, just above it, over it, and below it.
constexpr std::array<SkyRuns::Run, 4> kRuns = {{{.x = 0.1, .y = -0.9, .to_u = 0.1},
                                                {.x = 0.1, .y = 0.0, .to_u = 1.0},
                                                {.x = 0.1, .y = 0.1, .to_u = 1.0},
                                                {.x = 0.1, .y = 0.9, .to_u = 0.1}}};

TEST(SkyRuns, TellThoseOverTheEdgeOfTheEarth) {
    const View view;
    const SkyRuns runs = view.followed(kRuns);
    EXPECT_TRUE(runs.is_smooth(0));
    EXPECT_TRUE(runs.is_smooth(1));
    EXPECT_FALSE(runs.is_smooth(2));
    EXPECT_TRUE(runs.is_smooth(3));
}

TEST(SkyRuns, HaveMorePiecesWhereTheSkyBends) {
    const View view;
    const SkyRuns runs = view.followed(kRuns);
    EXPECT_EQ(runs.nodes(0).size(), 3U);
    EXPECT_GT(runs.nodes(1).size(), 8U);
    EXPECT_LE(runs.nodes(1).size(), 33U);
}

TEST(SkyRuns, HaveTheLightOfTheirMomentsAtTheNodes) {
    const View view;
    const SkyRuns runs = view.followed(kRuns);
    const std::span<const Float4> nodes = runs.nodes(1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const double u = static_cast<double>(i) / static_cast<double>(nodes.size() - 1);
        const Rgb sky = view.day.background(normalized(view.scene.direction_at(u, kRuns[1].x, kRuns[1].y)),
                                            up_at(view.scene.origin_at(u)));
        EXPECT_NEAR(nodes[i][0], sky.r, 2e-6F);
        EXPECT_NEAR(nodes[i][1], sky.g, 2e-6F);
        EXPECT_NEAR(nodes[i][2], sky.b, 2e-6F);
        EXPECT_EQ(nodes[i][3], kDepth);
    }
}

TEST(SkyRuns, HaveSoManyPiecesForSoManyPixels) {
    const View view;
    for (const auto& [pixels, pieces] : {std::pair(7, 2U), {8, 4U}, {24, 8U}, {10'000, 32U}}) {
        SkyRuns::Run run = kRuns[0];
        run.pixels = pixels;
        EXPECT_EQ(view.followed({&run, 1}).nodes(0).size(), pieces + 1U) << pixels;
    }
}

TEST(SkyRuns, AreTheSameInAnyCompany) {
    const View view;
    std::vector<SkyRuns::Run> many;
    while (many.size() < SkyRuns::kSize) many.push_back(kRuns[many.size() % kRuns.size()]);
    const SkyRuns together = view.followed(many);
    for (std::size_t k = 0; k < many.size(); ++k) {
        const SkyRuns alone = view.followed({&many[k], 1});
        ASSERT_EQ(alone.is_smooth(0), together.is_smooth(k));
        if (!alone.is_smooth(0)) continue;
        const auto is_same = [](Float4 a, Float4 b) {
            return a[0] == b[0] && a[1] == b[1] && a[2] == b[2] && a[3] == b[3];
        };
        EXPECT_TRUE(std::ranges::equal(alone.nodes(0), together.nodes(k), is_same)) << k;
    }
}

TEST(SkyRuns, LeftDarkAreSmoothAndBlack) {
    const View view;
    SkyRuns runs(view.scene, view.day, view.light, kDepth);
    for (const SkyRuns::Run& run : kRuns) runs.add(run);
    runs.leave_dark();
    for (std::size_t k = 0; k < kRuns.size(); ++k) {
        ASSERT_TRUE(runs.is_smooth(k));
        for (const Float4 node : runs.nodes(k)) {
            EXPECT_EQ(node[0] + node[1] + node[2], 0.0F);
            EXPECT_EQ(node[3], kDepth);
        }
    }
}

}  // namespace
}  // namespace overfly
