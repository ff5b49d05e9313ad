#include "core/background_tasks.h"

#include <gtest/gtest.h>

#include <atomic>

#include "core/parallel.h"

namespace overfly {
namespace {

TEST(BackgroundTasks, RunEachOnceBesideOtherWork) {
    std::atomic<int> in_background = 0, in_loop = 0;
    BackgroundTasks tasks;
    for (int round = 0; round < 10; ++round) {
        for (int k = 0; k < 20; ++k) tasks.run([&] { ++in_background; });
        parallel_for(50, [&](std::size_t) { ++in_loop; });
    }
    tasks.wait();
    EXPECT_EQ(in_background, 200);
    EXPECT_EQ(in_loop, 500);
}

TEST(BackgroundTasks, HaveEndedWhenTheyGo) {
    std::atomic<int> runs = 0;
    {
        BackgroundTasks tasks;
        for (int k = 0; k < 20; ++k) tasks.run([&] { ++runs; });
    }
    EXPECT_EQ(runs, 20);
}

TEST(BackgroundTasks, RunAtOnceWhereOneThreadIsAllowed) {
    const int before = thread_limit();
    limit_threads(1);
    {
        BackgroundTasks tasks;
        int runs = 0;
        tasks.run([&] { ++runs; });
        EXPECT_EQ(runs, 1);
    }
    limit_threads(before);
}

}  // namespace
}  // namespace overfly
