#include "core/parallel.h"

#include <memory>

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>

namespace overfly {
namespace {

// oneTBB limits threads for as long as this object lives; the limit belongs to the process, as threads do.
std::unique_ptr<tbb::global_control>& thread_control() {
    static std::unique_ptr<tbb::global_control> control;
    return control;
}

}  // namespace

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& task) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
            for (std::size_t i = range.begin(); i != range.end(); ++i) task(i);
        },
        tbb::simple_partitioner());
}

void limit_threads(int threads) {
    thread_control() = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                             static_cast<std::size_t>(threads));
}

int thread_limit() {
    const auto allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
    return static_cast<int>(allowed);
}

}  // namespace overfly
