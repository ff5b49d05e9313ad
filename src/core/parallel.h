#pragma once

#include <cstddef>
#include <functional>

namespace overfly {

// The one door to threads. Work is cut into `count` independent tasks; nothing a caller computes may depend on which
// thread ran which task or in what order.

// Runs task(i) for every i in [0, count), on at most thread_limit() threads, and returns when all are done.
// The first exception a task throws ends the loop early and is thrown again here.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task);

// As many threads as the machine has, until limit_threads says fewer. REQUIRES: threads >= 1.
void limit_threads(int threads);
[[nodiscard]] int thread_limit();

}  // namespace overfly
