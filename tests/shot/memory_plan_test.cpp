#include "shot/memory_plan.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace overfly {
namespace {

constexpr SceneMemory kScene = {0.9e9, 0.5e9};

ShotDocument shot_with(double memory_gb) {
    ShotDocument shot;
    shot.file = "dive.yaml";
    shot.memory_gb = memory_gb;
    return shot;
}

std::string refusal(double memory_gb, const FramesInMemory& frames) {
    try {
        static_cast<void>(plan_memory(shot_with(memory_gb), kScene, frames));
    } catch (const UserError& error) {
        return error.problems().front().text();
    }
    return "";
}

// Two threads may write, so 0.2 GB of frames are two fewer.
TEST(MemoryPlan, HasAsManyFramesAsFit) {
    const FramesInMemory frames = {100'000'000, 2, 1000};
    EXPECT_EQ(plan_memory(shot_with(1.7), kScene, frames).frames, 10U);
    EXPECT_EQ(plan_memory(shot_with(1.69), kScene, frames).frames, 9U);
    EXPECT_EQ(plan_memory(shot_with(4.0), kScene, frames).frames, 33U);
    for (const double allowed_gb : {0.9, 1.0, 1.23, 3.7, 20.0}) {
        const MemoryPlan plan = plan_memory(shot_with(allowed_gb), kScene, frames);
        EXPECT_LE(plan.bytes_with(plan.frames), plan.allowed_bytes);
        EXPECT_GT(plan.bytes_with(plan.frames + 1), plan.allowed_bytes);
    }
}

TEST(MemoryPlan, HasNoMoreFramesThanThereIsWorkFor) {
    EXPECT_EQ(plan_memory(shot_with(4.0), kScene, {1'000'000, 2, 16}).frames, 16U);
    EXPECT_EQ(plan_memory(shot_with(4.0), kScene, {1'000'000, 2, 1}).frames, 2U);
}

TEST(MemoryPlan, SaysWhatThereIs) {
    EXPECT_EQ(plan_memory(shot_with(4.0), kScene, {31'000'000, 2, 12}).text(),
              "memory: 0.90 GB for the scene, 31.0 MB a frame, 12 frames at once, of 4 GB");
}

TEST(MemoryPlan, RefusesWhatTwoFramesDontFitInto) {
    EXPECT_EQ(refusal(0.9, {100'000'000, 1, 16}), "");
    EXPECT_EQ(refusal(0.899, {100'000'000, 1, 16}),
              "dive.yaml: memory_gb: got 0.899, but 0.90 is the least: 0.90 GB for the scene, and two frames of "
              "100.0 MB and what writing them takes");
    EXPECT_EQ(refusal(4.0, {1'000'000'000, 2, 16}),
              "dive.yaml: memory_gb: got 4, but 4.50 is the least: 0.90 GB for the scene, and two frames of 1000.0 MB "
              "and what writing them takes");
    EXPECT_EQ(refusal(4.5, {1'000'000'000, 2, 16}), "");
}

// What was measured (docs/kinetic.md): it must be enough, and not much more.
TEST(MemoryPlan, ReckonsScenesFromAbove) {
    const auto expect_reckoned = [](const SceneSizes& sizes, double frames_bytes, double measured_bytes) {
        const SceneMemory scene = scene_memory(sizes);
        const double reckoned_bytes = std::max(scene.making_bytes, scene.kept_bytes + frames_bytes);
        EXPECT_GE(reckoned_bytes, measured_bytes);
        EXPECT_LE(reckoned_bytes, 1.3 * measured_bytes);
    };
    const SceneSizes demo = {941'094, 471'000, 132'771, false, 0, 960UL * 540UL};
    expect_reckoned(demo, 0.0, 0.309e9);
    SceneSizes all = demo;
    all.triangles = all.full_triangles;
    expect_reckoned(all, 6 * 10.4e6, 0.395e9);
    const SceneSizes small = {941'094, 471'000, 21'500, false, 0, 96UL * 54UL};
    expect_reckoned(small, 0.0, 0.297e9);
    SceneSizes of_all_layers = small;
    of_all_layers.ground_facts = 4;
    expect_reckoned(of_all_layers, 0.0, 0.345e9);
    SceneSizes large = {12'954'898, 6'480'000, 269'194, false, 0, 480UL * 270UL};
    expect_reckoned(large, 0.0, 1.863e9);
    large.ground_facts = 4;
    expect_reckoned(large, 0.0, 2.925e9);
}

}  // namespace
}  // namespace overfly
