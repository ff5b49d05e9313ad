#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>

#include "core/parallel.h"
#include "core/progress.h"

namespace overfly {

// f(i) for i in [0, count) from all threads, a block of neighbours at a time, and what of it is done so far.
template <class F>
void parallel_blocks(std::size_t count, const char* what, const Progress& progress, const F& f) {
    constexpr std::size_t kBlock = 4096;
    const std::size_t blocks = (count + kBlock - 1) / kBlock;
    std::mutex mutex;
    std::size_t done = 0;
    parallel_for(blocks, [&](std::size_t block) {
        const std::size_t end = std::min(count, (block + 1) * kBlock);
        for (std::size_t i = block * kBlock; i < end; ++i) f(i);
        if (!progress) return;
        const std::scoped_lock lock(mutex);
        progress(what, static_cast<double>(++done), static_cast<double>(blocks));
    });
}

}  // namespace overfly
