#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>

#include "core/parallel.h"
#include "core/progress.h"

namespace overfly {

// f(task) for tasks in [0, count) from all threads, and what of it is done so far.
template <class F>
void parallel_tasks(std::size_t count, const char* what, const Progress& progress, const F& f) {
    std::mutex mutex;
    std::size_t done = 0;
    parallel_for(count, [&](std::size_t task) {
        f(task);
        if (!progress) return;
        const std::scoped_lock lock(mutex);
        progress(what, static_cast<double>(++done), static_cast<double>(count));
    });
}

// f(begin, end) for [0, count) cut into blocks of neighbours.
template <class F>
void parallel_ranges(std::size_t count, const char* what, const Progress& progress, const F& f) {
    constexpr std::size_t kBlock = 4096;
    parallel_tasks((count + kBlock - 1) / kBlock, what, progress,
                   [&](std::size_t block) { f(block * kBlock, std::min(count, (block + 1) * kBlock)); });
}

// f(i) for i in [0, count), a block of neighbours at a time.
template <class F>
void parallel_blocks(std::size_t count, const char* what, const Progress& progress, const F& f) {
    parallel_ranges(count, what, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) f(i);
    });
}

}  // namespace overfly
