#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace overfly {
namespace {

TEST(Parallel, RunsEveryTaskOnce) {
    std::vector<std::atomic<int>> runs(1000);
    parallel_for(runs.size(), [&](std::size_t i) { ++runs[i]; });
    for (const auto& count : runs) EXPECT_EQ(count, 1);
}

TEST(Parallel, ThrowsWhatATaskThrows) {
    const auto run = [] {
        parallel_for(100, [](std::size_t i) {
            if (i == 42) throw std::runtime_error("task 42");
        });
    };
    EXPECT_THROW(run(), std::runtime_error);
}

TEST(Parallel, TheLimitHolds) {
    const int before = thread_limit();
    limit_threads(1);
    EXPECT_EQ(thread_limit(), 1);
    limit_threads(before);
}

}  // namespace
}  // namespace overfly
